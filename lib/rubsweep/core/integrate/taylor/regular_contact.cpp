#include "rubsweep/core/integrate/taylor/regular_contact.hpp"

#include <algorithm>
#include <cmath>

namespace rubsweep::integrate::taylor {

using contact::Mode;
using numerics::product_term;
using numerics::Twin;

/// Coefficient k of p^n / p, a root, a penetration or their product.
double RegularContact::factor_term(int k, double penetration) {
  if (k == 0) {
    root_.set(0, std::sqrt(std::max(0.0, penetration)));
    twice_root_inverse_ = 0.5 / root_[0];
  } else if (power_.rooted() && !is_pace_) {
    root_.set(k, (penetration - numerics::inner_square(root_, k)) * twice_root_inverse_);
  }
  if (power_.halves == 2) return k == 0 ? 1 : 0;
  if (power_.halves == 3) return root_[k];
  if (power_.halves == 4) return penetration;
  penetration_.set(k, penetration);
  return product_term(power_.rooted() ? root_ : penetration_, penetration_, k);
}

/// The force is N n + mu S t with S = K p^n and N = S (1 + c p'). Coefficient k of N and S from that of p and
/// p'. `products`: those of factors and rates without the first and the last.
Twin RegularContact::normal_term(int k, Twin newest, Twin products) {
  rates_.set(k, newest);
  double spring = 0;
  if (by_quotient_) {  // k p0 S_k = (n + 1) (p' S)_{k-1} - k times the sum of p_j S_{k-j}, from p S' = n p' S
    if (k == 0) {
      spring = power_.force_n(newest[0]);
      penetration_inverse_ = 1 / newest[0];
    } else {
      const double sum = products[0] + factors_[0][0] * newest[0];
      spring = ((power_.exponent + 1) * numerics::one_over(k) * damper_term_ - sum) * penetration_inverse_;
    }
    factors_.set(k, spring);
  } else {
    const double factor = factor_term(k, newest[0]);
    spring = k == 0 ? factor * newest[0] : products[0] + factors_[0][0] * newest[0] + factor * rates_[0][0];
    spring *= power_.factor;
    factors_.set(k, Twin{factor, spring});
  }
  damper_term_ = spring * rates_[0][1];
  if (k > 0) damper_term_ += products[1] + factors_[0][1] * newest[1];
  return mode_ == Mode::sprung ? Twin{spring + damping_ * damper_term_, spring} : Twin{0, spring};
}

/// Coefficient k of S' and of the elastic force S, after `power_term`, in order of k.
Twin RegularContact::elastic_term(int k) {
  const double exponent = power_.exponent;
  if (!by_quotient_) return Twin{power_.factor * exponent, 1} * factors_[k];
  double slope = exponent * factors_.number(k);
  for (int j = 1; j <= k; ++j) slope -= rates_[j][0] * slope_.number(k - j);
  slope_.set(k, slope * penetration_inverse_);
  return Twin{slope_.number(k), factors_.number(k)};
}

Twin RegularContact::straight_term(int k) {
  const Twin products = numerics::sum_of_products(factors_, rates_, k, 1, k - 1);
  const Twin force = normal_term(k, Twin{penetration_term(k), velocity_[k][0]}, products);
  if (!varies_) return Twin{force[0], constant_mu_ * force[1]};
  load_.set(k, Twin{force[1], 0});
  sliding_.set(k, velocity_[k][1]);
  add_slip_term(slip_term(k), k);
  return Twin{force[0], product_term(mu_, load_, k)[0]};
}

Twin RegularContact::round_term(int k) {
  // Sums without the first and the last product: they need not wait for the newest coefficients.
  Twin products{}, by_length{}, by_velocity{}, pressed{}, load{};
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
  const Twin force = normal_term(k, Twin{penetration_term(k), length_rate_.number(k)}, products);
  pressed_.set(k, force[0]);
  spring_.set(k, force[1]);
  pressed += pressed_[k] * normal_[0];
  load += spring_[k] * normal_[0];
  if (k > 0) {
    pressed += pressed_[0] * normal_[k];
    load += spring_[0] * normal_[k];
  }
  if (sticks_) return with_holding(pressed, k);
  if (!varies_) return pressed + turned_mu_ * numerics::swapped(load);
  load_.set(k, load);
  add_sliding_term(k);
  add_slip_term(slip_term(k), k);
  return pressed + numerics::quarter_turned(product_term(mu_, load_, k));
}

}  // namespace rubsweep::integrate::taylor
