#include "rubsweep/core/integrate/taylor/contact_jacobian.hpp"

namespace rubsweep::integrate::taylor {

using numerics::both;
using numerics::PlaneSeries;
using numerics::product_term;
using numerics::sum_of_products;
using numerics::Twin;

void ContactJacobian::read_law() {
  const ContactSeries& contact = *contact_;
  const ContactLaw& law = contact.law();
  const double stiffness = law.stiffness;
  spring_ = contact::law_of(contact.mode()).spring * stiffness;
  friction_ = contact.constant_coefficient() * stiffness;
  damper_ = law.damper(contact.mode());
  clearance_ = law.clearance;
}

/// Computes coefficient k of n1 n and the quantities that depend on it only.
void ContactJacobian::make_along(int k) {
  const PlaneSeries& n = contact_->normal();
  normal_first_.set(k, numerics::first_twice(n[k]));
  const Twin along = product_term(normal_first_, n, k);
  const double one = k == 0 ? 1 : 0;
  along_.set(k, along);
  across_.set(k, Twin{one, 0} - along);
  first_damped_.set(k, both(damper_) * along);
  second_damped_.set(k, both(damper_) * Twin{along[1], one - along[0]});
}

/// Product of K (s + mu Q) and a column.
Twin ContactJacobian::spring_column(double along, double across) const {
  const Twin column{along, across};
  return both(spring_) * column + both(friction_) * numerics::quarter_turned(column);
}

void ContactJacobian::make(int k) {
  const PlaneSeries &n = contact_->normal(), &r = contact_->length(), &speed = contact_->length_rate();
  if (k == 0) read_law();
  if (k == 0 || !damped()) make_along(k);
  if (damped()) make_along(k + 1);
  const double one = k == 0 ? 1 : 0;
  const Twin products = sum_of_products(r, inverse_, k, 1, k);
  inverse_.set(k, (both(one) - products) * both(contact_->inverse_length()));
  const double inverse = inverse_.number(k);
  const Twin bend = product_term(inverse_, across_, k);
  bend_.set(k, bend);
  first_.set(k, spring_column(one - clearance_ * bend[0], -clearance_ * bend[1]));
  second_.set(k, spring_column(-clearance_ * bend[1], one - clearance_ * (inverse - bend[0])));
  if (!damped()) return;
  // r' T / r, given by its first column; then r' / r and n1' n2.
  const Twin shrinking = product_term(speed, bend_, k), turning = both(k + 1) * along_[k + 1];
  rates_.set(k, Twin{speed.number(k), (k + 1) * n[k + 1][0]});
  factors_.set(k, Twin{inverse, n[k][1]});
  const Twin mixed = product_term(rates_, factors_, k);
  // (n n^T)' is n' n^T plus its transpose, and n . n' is zero.
  const double n1_n1 = turning[0] / 2, n2_n1 = turning[1] - mixed[1];
  first_.set(k, first_[k] + both(damper_) * (shrinking - Twin{n1_n1, n2_n1}));
  second_.set(
      k, second_[k] + both(damper_) * (Twin{shrinking[1], mixed[0] - shrinking[0]} - Twin{mixed[1], -n1_n1}));
}

}  // namespace rubsweep::integrate::taylor
