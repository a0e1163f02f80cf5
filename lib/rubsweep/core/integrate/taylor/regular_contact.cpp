#include "rubsweep/core/integrate/taylor/regular_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rubsweep::integrate::taylor {

using contact::Mode;
using numerics::both;
using numerics::product_term;
using numerics::Twin;

PowerLaw::PowerLaw(const contact::CurvedLaw* law, double length_m) {
  if (!law || law->law().kind != model::ForceCurve::power) return;
  const double exponent = law->law().exponent;
  if (2 * exponent != std::floor(2 * exponent)) return;
  halves = static_cast<int>(2 * exponent);
  factor = law->law().stiffness_n_per_m_n * std::pow(length_m, exponent);
}

/// Coefficient k of K p^n, a product of penetrations and, for a rooted law, their root.
double RegularContact::spring_term(int k) {
  penetration_.set(k, penetration_term(k));
  if (k == 0) {
    root_.set(0, std::sqrt(std::max(0.0, penetration_[0])));
  } else if (power_.rooted() && !is_pace_) {
    root_.set(k, (penetration_[k] - numerics::inner_square(root_, k)) / (2 * root_[0]));
  }
  const numerics::Series* product = power_.rooted() ? &root_ : &penetration_;
  const auto times = static_cast<std::size_t>((power_.halves - 1) / 2);
  for (std::size_t i = 0; i < times; ++i) {
    products_[i].set(k, product_term(*product, penetration_, k));
    product = &products_[i];
  }
  return power_.factor * (*product)[k];
}

/// The force is S (1 + c p') n + mu S t with S = K p^n.
Twin RegularContact::power_term(int k) {
  const bool presses = mode_ == Mode::sprung, damped = presses && damping_[0] > 0;
  if (!law_->annular) {
    const double spring = spring_term(k);
    load_.set(k, Twin{spring, 0});
    const double damper = damped ? (damping_ * product_term(velocity_, load_, k))[0] : 0;
    const double normal = presses ? spring + damper : 0;
    if (!varies_) return Twin{normal, constant_mu_ * spring};
    sliding_.set(k, velocity_[k][1]);
    add_slip_term(slip_term(k), k);
    return Twin{normal, product_term(mu_, load_, k)[0]};
  }
  normal_and_rate<false>(k);
  spring_.set(k, both(spring_term(k)));
  const Twin load = product_term(spring_, normal_, k);
  load_.set(k, load);
  Twin force = presses ? load : Twin{};
  if (damped) force += damping_ * product_term(length_rate_, load_, k);
  if (!varies_) return force + turned_mu_ * numerics::swapped(load);
  add_sliding_term(k);
  add_slip_term(slip_term(k), k);
  return force + numerics::quarter_turned(product_term(mu_, load_, k));
}

void RegularContact::advance(int k, const numerics::Series* pace) {
  const double next = numerics::one_over(k + 1);
  if (law_->annular) {
    double rate = pace ? 0 : length_rate_.number(k);
    for (int j = 0; pace && j <= k; ++j) rate += length_rate_.number(j) * (*pace)[k - j];
    length_.set(k + 1, rate * next);
  }
  if (is_pace_) root_.set(k + 1, closing_term(k) * next / 2);
}

}  // namespace rubsweep::integrate::taylor
