#include "rubsweep/integrate/taylor/contact_tangent.hpp"

namespace rubsweep::integrate::taylor {

using numerics::both;
using numerics::PlaneSeries;
using numerics::product_term;
using numerics::quarter_turned;
using numerics::sum_of;
using numerics::swapped;
using numerics::Twin;

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

void ContactTangent::begin(Twin displacement) {
  displacement_.set(0, displacement);
  if (annular_) length_.set(0, sum_of(contact_->normal()[0] * displacement));
}

Twin ContactTangent::force_term(int k, Twin rate) {
  rate_.set(k, rate);
  displacement_.set(k + 1, rate * both(numerics::one_over(k + 1)));
  return annular_ ? annular_term(k) : flat_term(k);
}

Twin ContactTangent::coefficient_term(double sliding, int k) {
  sliding_.set(k, sliding);
  coefficient_.set(k, product_term(slope_, sliding_, k));
  return coefficient_[k];
}

/// Normal force K (factor p) + d v, friction mu(slip) K p.
Twin ContactTangent::flat_term(int k) {
  const double load = stiffness_ * displacement_[k][0];
  const double normal = spring_factor_ * load + damper_ * rate_[k][0];
  if (!varies_) return Twin{normal, friction_ * load};
  load_.set(k, Twin{load, 0});
  coefficient_term(rate_[k][1], k);
  const Twin friction =
      product_term(coefficient_, contact_->load(), k) + product_term(contact_->coefficient(), load_, k);
  return Twin{normal, friction[0]};
}

/// With m the change of the normal n: the change of r is n . w, r m = w - n (n . w), and that of r' n, which
/// is returned with `damped`, is (n . w)' n + r' m. Coefficient k of m, and k + 1 of n . w.
template <bool damped>
Twin ContactTangent::normal_and_rate(int k) {
  const PlaneSeries &n = contact_->normal(), &r = contact_->length(), &rate = contact_->length_rate();
  Twin along = n[k + 1] * displacement_[0] + n[0] * displacement_[k + 1] + n[k] * displacement_[1];
  if (k == 0) along -= n[0] * displacement_[1];
  Twin by_length = n[k] * length_[0], by_normal{}, first{}, second{};
  for (int j = 1; j <= k; ++j) {
    const Twin normal = n[k - j];
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
  if constexpr (!damped) return Twin{};
  return first + second + n[0] * length_rate_[k] + rate[0] * normal_[k];
}

Twin ContactTangent::annular_term(int k) {
  const Twin damping = damper_ == 0 ? normal_and_rate<false>(k) : both(damper_) * normal_and_rate<true>(k);
  const Twin load = both(stiffness_) * (displacement_[k] - both(clearance_) * normal_[k]);
  const Twin force = both(spring_factor_) * load + damping;
  if (sticks_) return force + quarter_turned(product_term(contact_->holding(), normal_, k));
  if (!varies_) return force + both(friction_) * quarter_turned(load);
  load_.set(k, load);
  Twin sliding{};
  for (int j = 0; j <= k; ++j)
    sliding +=
        normal_[j] * swapped(contact_->velocity()[k - j]) + contact_->normal()[j] * swapped(rate_[k - j]);
  coefficient_term(sliding[0] - sliding[1], k);
  return force + quarter_turned(product_term(coefficient_, contact_->load(), k) +
                                product_term(contact_->coefficient(), load_, k));
}

}  // namespace rubsweep::integrate::taylor
