#include "rubsweep/integrate/taylor/contact_tangent.hpp"

namespace rubsweep::integrate::taylor {

using numerics::both;
using numerics::PlaneSeries;
using numerics::product_term;
using numerics::quarter_turned;
using numerics::sum_of;
using numerics::Two;

void ContactTangent::follow(const ContactSeries& contact, int order) {
  contact_ = &contact;
  const ContactLaw& law = contact.law();
  stiffness_ = law.stiffness;
  clearance_ = law.clearance;
  spring_factor_ = contact::law_of(contact.mode()).spring;
  damper_ = law.damper(contact.mode());
  friction_ = contact.constant_coefficient();
  varies_ = contact.friction_varies() && !contact.sticks();
  sticks_ = contact.sticks();
  annular_ = law.annular;
  if (!varies_) return;
  for (int k = 0; k < order; ++k) slope_.set(k, contact.friction_slope_term(k));
}

void ContactTangent::begin(Two displacement) {
  displacement_.set(0, displacement);
  if (annular_) length_.set(0, sum_of(contact_->normal()[0] * displacement));
}

Two ContactTangent::force_term(int k, Two rate) {
  rate_.set(k, rate);
  displacement_.set(k + 1, rate * both(numerics::one_over(k + 1)));
  return annular_ ? annular_term(k) : flat_term(k);
}

Two ContactTangent::coefficient_term(double sliding, int k) {
  sliding_.set(k, sliding);
  coefficient_.set(k, product_term(slope_, sliding_, k));
  return coefficient_[k];
}

/// Normal force K (factor p) + d v, friction mu(slip) K p.
Two ContactTangent::flat_term(int k) {
  const double load = stiffness_ * displacement_[k][0];
  const double normal = spring_factor_ * load + damper_ * rate_[k][0];
  if (!varies_) return Two{normal, friction_ * load};
  load_.set(k, Two{load, 0});
  coefficient_term(rate_[k][1], k);
  const Two friction = product_term(coefficient_, contact_->load(), k) +
                       product_term(contact_->coefficient(), load_, k);
  return Two{normal, friction[0]};
}

/// With m the change of the normal n: the change of r is n . w, r m = w - n (n . w), and that of r' n, which is
/// returned with `damped`, is (n . w)' n + r' m. Coefficient k of m, and k + 1 of n . w.
template <bool damped>
Two ContactTangent::normal_and_rate(int k) {
  const PlaneSeries &n = contact_->normal(), &r = contact_->length(), &rate = contact_->length_rate();
  Two along = n[k + 1] * displacement_[0] + n[0] * displacement_[k + 1] + n[k] * displacement_[1];
  if (k == 0) along -= n[0] * displacement_[1];
  Two by_length = n[k] * length_[0], by_normal{}, first{}, second{};
  for (int j = 1; j <= k; ++j) {
    const Two normal = n[k - j];
    if (j < k) along += normal * displacement_[j + 1];
    by_length += normal * length_[j];
    by_normal += r[j] * normal_[k - j];
    if constexpr (damped) {
      first += n[j] * length_rate_[k - j];
      second += rate[j] * normal_[k - j];
    }
  }
  length_.set(k + 1, sum_of(along));
  length_rate_.set(k, both(k + 1) * length_[k + 1]);
  normal_.set(k, (displacement_[k] - by_length - by_normal) * both(contact_->inverse_length()));
  if constexpr (!damped) return Two{};
  return first + second + n[0] * length_rate_[k] + rate[0] * normal_[k];
}

Two ContactTangent::annular_term(int k) {
  const Two damping = damper_ == 0 ? normal_and_rate<false>(k) : both(damper_) * normal_and_rate<true>(k);
  const Two load = both(stiffness_) * (displacement_[k] - both(clearance_) * normal_[k]);
  const Two force = both(spring_factor_) * load + damping;
  if (sticks_) return force + quarter_turned(product_term(contact_->holding(), normal_, k));
  if (!varies_) return force + both(friction_) * quarter_turned(load);
  load_.set(k, load);
  double sliding = 0;
  for (int j = 0; j <= k; ++j) {
    const Two m = normal_[j], n = contact_->normal()[j], v = contact_->velocity()[k - j], w = rate_[k - j];
    sliding += (m[0] * v[1] - m[1] * v[0]) + (n[0] * w[1] - n[1] * w[0]);
  }
  coefficient_term(sliding, k);
  return force + quarter_turned(product_term(coefficient_, contact_->load(), k) +
                                product_term(contact_->coefficient(), load_, k));
}

}  // namespace rubsweep::integrate::taylor
