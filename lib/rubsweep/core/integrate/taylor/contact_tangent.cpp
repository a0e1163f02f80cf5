#include "rubsweep/core/integrate/taylor/contact_tangent.hpp"

namespace rubsweep::integrate::taylor {

using numerics::both;
using numerics::first_twice;
using numerics::PlaneSeries;
using numerics::product_term;
using numerics::quarter_turned;
using numerics::second_twice;
using numerics::sum_of;
using numerics::swapped;
using numerics::Twin;

template <int Count>
void ContactTangents<Count>::follow(const ContactSeries& contact, ContactJacobian& jacobian, int order) {
  contact_ = &contact;
  jacobian_ = &jacobian;
  const ContactLaw& law = contact.law();
  stiffness_ = law.stiffness;
  clearance_ = law.clearance;
  spring_factor_ = contact::law_of(contact.mode()).spring;
  damper_ = law.damper(contact.mode());
  friction_ = contact.constant_coefficient();
  varies_ = contact.friction_varies() && !contact.sticks();
  sticks_ = contact.sticks();
  annular_ = law.annular;
  linear_ = Count > 1 && annular_ && !varies_ && !sticks_;
  if (!varies_) return;
  for (int k = 0; k < order; ++k) slope_.set(k, contact.friction_slope_term(k));
}

template <int Count>
void ContactTangents<Count>::begin(const Term& displacement) {
  for (std::size_t i = 0; i < count; ++i) put(0, i, displacement[i]);
  if (!annular_ || linear_) return;
  for (std::size_t i = 0; i < count; ++i) length_.set(0, i, sum_of(contact_->normal()[0] * displacement[i]));
}

template <int Count>
void ContactTangents<Count>::put(int k, std::size_t which, Twin displacement) {
  if (linear_) {
    along_first_.set(k, which, first_twice(displacement));
    along_second_.set(k, which, second_twice(displacement));
  } else {
    displacement_.set(k, which, displacement);
  }
}

template <int Count>
auto ContactTangents<Count>::force_term(int k, const Term& rate) -> Term {
  const Twin next = numerics::one_over_twice(k + 1);
  for (std::size_t i = 0; i < count; ++i) put(k + 1, i, rate[i] * next);
  if (linear_) {
    jacobian_->extend(k);
    return jacobian_->damped() ? linear_term<true>(k) : linear_term<false>(k);
  }
  rate_.set(k, rate);
  return annular_ ? annular_term(k) : flat_term(k);
}

/// Coefficient k of (B w)' + A w. Both matrices are combined first: all vectors share the factor k + 1.
template <int Count>
template <bool damped>
auto ContactTangents<Count>::linear_term(int k) -> Term {
  Term sum{};
  const Twin derivative = both(k + 1);
  const auto add = [&](int j, Twin first, Twin second) {
    const Term &x = along_first_[j], &y = along_second_[j];
    for (std::size_t i = 0; i < count; ++i) sum[i] += first * x[i] + second * y[i];
  };
  // The newest coefficient of the vectors comes last: the other terms need not wait for it.
  for (int j = 0; j <= k; ++j) {
    Twin first = jacobian_->first(k - j), second = jacobian_->second(k - j);
    if constexpr (damped) {
      first += derivative * jacobian_->first_damped(k + 1 - j);
      second += derivative * jacobian_->second_damped(k + 1 - j);
    }
    add(j, first, second);
  }
  if constexpr (damped)
    add(k + 1, derivative * jacobian_->first_damped(0), derivative * jacobian_->second_damped(0));
  return sum;
}

template <int Count>
void ContactTangents<Count>::add_coefficient_term(std::size_t which, double sliding, int k) {
  sliding_.set(k, which, both(sliding));
  coefficient_.set(k, which, product_term(slope_, sliding_.member(which), k));
}

/// Variation of the friction force, mu times a force whose variation is `load`.
template <int Count>
Twin ContactTangents<Count>::sliding_friction(std::size_t which, Twin load, int k) {
  load_.set(k, which, load);
  return product_term(coefficient_.member(which), contact_->load(), k) +
         product_term(contact_->coefficient(), load_.member(which), k);
}

/// Normal force K (factor p) + d v and friction mu(slip) K p.
template <int Count>
auto ContactTangents<Count>::flat_term(int k) -> Term {
  Term force;
  for (std::size_t i = 0; i < count; ++i) {
    const double load = stiffness_ * displacement_[k][i][0];
    const double normal = spring_factor_ * load + damper_ * rate_[k][i][0];
    if (!varies_) {
      force[i] = Twin{normal, friction_ * load};
      continue;
    }
    add_coefficient_term(i, rate_[k][i][1], k);
    force[i] = Twin{normal, sliding_friction(i, Twin{load, 0}, k)[0]};
  }
  return force;
}

/// With m the change of the normal n: the change of r is n . w, r m = w - n (n . w), and the change of r' n,
/// returned if `damped`, is (n . w)' n + r' m. Computes coefficient k of m and k + 1 of n . w.
template <int Count>
template <bool damped>
auto ContactTangents<Count>::normal_and_rate(int k) -> Term {
  const PlaneSeries &n = contact_->normal(), &r = contact_->length();
  Term along, by_length{}, by_normal{};
  for (std::size_t i = 0; i < count; ++i) along[i] = n[k + 1] * displacement_[0][i];
  // The newest coefficient of the vectors comes last: the other terms need not wait for it.
  for (int j = 0; j < k; ++j) {
    const Twin normal = n[k - j], length = r[k - j];
    const Term &w = displacement_[j + 1], &change = length_[j], &turn = normal_[j];
    for (std::size_t i = 0; i < count; ++i) {
      along[i] += normal * w[i];
      by_length[i] += normal * change[i];
      by_normal[i] += length * turn[i];
    }
  }
  const Twin inverse_length = both(contact_->inverse_length());
  for (std::size_t i = 0; i < count; ++i) {
    along[i] += n[0] * displacement_[k + 1][i];
    by_length[i] += n[0] * length_[k][i];
    const Twin change = sum_of(along[i]);
    length_.set(k + 1, i, change);
    length_rate_.set(k, i, both(k + 1) * change);
    normal_.set(k, i, (displacement_[k][i] - by_length[i] - by_normal[i]) * inverse_length);
  }
  return damped ? damping_products(k) : Term{};
}

/// Coefficient k of (n . w)' n + r' m.
template <int Count>
auto ContactTangents<Count>::damping_products(int k) const -> Term {
  const PlaneSeries &n = contact_->normal(), &rate = contact_->length_rate();
  Term first{}, second{};
  for (int j = 0; j < k; ++j) {
    const Twin normal = n[k - j], speed = rate[k - j];
    const Term &change = length_rate_[j], &turn = normal_[j];
    for (std::size_t i = 0; i < count; ++i) {
      first[i] += normal * change[i];
      second[i] += speed * turn[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    first[i] = first[i] + second[i] + rate[0] * normal_[k][i] + n[0] * length_rate_[k][i];
  return first;
}

template <int Count>
auto ContactTangents<Count>::annular_term(int k) -> Term {
  const Term damping = damper_ == 0 ? normal_and_rate<false>(k) : normal_and_rate<true>(k);
  Term all;
  for (std::size_t i = 0; i < count; ++i) {
    const Twin load = both(stiffness_) * (displacement_[k][i] - both(clearance_) * normal_[k][i]);
    const Twin damped = damper_ == 0 ? Twin{} : both(damper_) * damping[i];
    Twin force = both(spring_factor_) * load;
    if (sticks_) {
      force += quarter_turned(product_term(contact_->holding(), normal_.member(i), k));
    } else if (!varies_) {
      force += both(friction_) * quarter_turned(load);
    } else {
      Twin sliding{};
      for (int j = 0; j <= k; ++j)
        sliding += normal_[j][i] * swapped(contact_->velocity()[k - j]) +
                   contact_->normal()[j] * swapped(rate_[k - j][i]);
      add_coefficient_term(i, sliding[0] - sliding[1], k);
      force += quarter_turned(sliding_friction(i, load, k));
    }
    all[i] = force + damped;
  }
  return all;
}

template class ContactTangents<1>;
template class ContactTangents<tangents_together>;

}  // namespace rubsweep::integrate::taylor
