#include "rubsweep/core/integrate/taylor/regular_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rubsweep::integrate::taylor {

using contact::Mode;
using numerics::product_term;
using numerics::Twin;

/// Coefficient k of p^n / p, a root, a penetration or their product.
double RegularContact::factor_term(int k) {
  if (k == 0) {
    root_.set(0, std::sqrt(std::max(0.0, penetration_[0])));
    twice_root_inverse_ = 0.5 / root_[0];
  } else if (power_.rooted() && !is_pace_) {
    root_.set(k, (penetration_[k] - numerics::inner_square(root_, k)) * twice_root_inverse_);
  }
  switch (power_.halves) {
    case 2:
      return k == 0 ? 1 : 0;
    case 3:
      return root_[k];
    case 4:
      return penetration_[k];
    default:
      return product_term(power_.rooted() ? root_ : penetration_, penetration_, k);
  }
}

/// The force is N n + mu S t with S = K p^n and N = S (1 + c p').
Twin RegularContact::power_term(int k) {
  const bool annular = law_->annular;
  // Sums without the first and the last product: they need not wait for the newest coefficients.
  Twin products{}, by_length{}, by_velocity{}, pressed{}, load{};
  if (annular) {
    for (int j = 1; j < k; ++j) {
      const Twin normal = normal_[k - j];
      products += factors_[j] * rates_[k - j];
      by_length += length_[j] * normal;
      by_velocity += velocity_[j] * normal;
      pressed += pressed_[j] * normal;
      load += spring_[j] * normal;
    }
    if (k == 0) {
      normal_and_rate<false>(0);
    } else {  // r n = d and r' = n . d'
      const Twin normal = (distance_[k] - (by_length + length_[k] * normal_[0])) * inverse_length_;
      normal_.set(k, normal);
      length_rate_.set(k, numerics::sum_of(by_velocity + velocity_[k] * normal_[0] + velocity_[0] * normal));
    }
  } else {
    products = numerics::sum_of_products(factors_, rates_, k, 1, k - 1);
  }
  penetration_.set(k, penetration_term(k));
  closing_.set(k, annular ? length_rate_.number(k) : velocity_[k][0]);
  const Twin newest{penetration_[k], closing_[k]};
  rates_.set(k, newest);
  const double factor = factor_term(k);
  const Twin first = k == 0 ? Twin{factor, 0} : factors_[0];
  double spring = products[0] + first[0] * newest[0] + (k > 0 ? factor * rates_[0][0] : 0);
  spring *= power_.factor;
  factors_.set(k, Twin{factor, spring});
  double damper = products[1] + spring * rates_[0][1] + (k > 0 ? first[1] * newest[1] : 0);
  const double normal = mode_ == Mode::sprung ? spring + damping_ * damper : 0;
  if (!annular) {
    if (!varies_) return Twin{normal, constant_mu_ * spring};
    load_.set(k, Twin{spring, 0});
    sliding_.set(k, velocity_[k][1]);
    add_slip_term(slip_term(k), k);
    return Twin{normal, product_term(mu_, load_, k)[0]};
  }
  pressed_.set(k, normal);
  spring_.set(k, spring);
  pressed += pressed_[k] * normal_[0];
  load += spring_[k] * normal_[0];
  if (k > 0) {
    pressed += pressed_[0] * normal_[k];
    load += spring_[0] * normal_[k];
  }
  if (!varies_) return pressed + turned_mu_ * numerics::swapped(load);
  load_.set(k, load);
  add_sliding_term(k);
  add_slip_term(slip_term(k), k);
  return pressed + numerics::quarter_turned(product_term(mu_, load_, k));
}

}  // namespace rubsweep::integrate::taylor
