#include "rubsweep/core/integrate/taylor/contact_series.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/integrate/taylor/creep.hpp"

namespace rubsweep::integrate::taylor {

using contact::Mode;
using numerics::both;
using numerics::PlaneSeries;
using numerics::quarter_turned;
using numerics::sum_of;
using numerics::sum_of_products;
using numerics::Twin;

void ContactSeries::begin(const ContactLaw& law, Mode mode, double slip_m_per_s, contact::Slip way,
                          bool poised) {
  law_ = &law;
  mode_ = mode;
  spring_factor_ = both(contact::law_of(mode).spring);
  damper_ = both(law.damper(mode));
  stiffness_ = both(law.stiffness);
  clearance_ = both(law.clearance);
  sliding_made_ = false;
  saturated_steepness_ = 0;
  // Every term that this series adds up has a name here, so that a further one does not compile.
  [[maybe_unused]] const auto& [sum, count, constant, dry_part, holding, falling, viscous] = law.friction;
  const bool dry = holding > 0;
  sticks_ = dry && mode != Mode::open && way == contact::Slip::sticking;
  creep_ = nullptr;
  slip_sign_ = dry ? contact::sign_of(way) : std::copysign(1.0, slip_m_per_s);
  const double sliding = poised ? law.friction.holding : law.friction.dry;
  constant_mu_ = dry ? sliding * slip_sign_ : law.friction.constant;
  varies_ = law.friction.viscous_s_per_m != 0;
  for (std::size_t i = 0; i < law.friction.count; ++i) {
    const auto& term = law.friction.tanh[i];
    active_[i] = std::abs(term.steepness_s_per_m * slip_m_per_s) < saturated_at_start;
    varies_ = varies_ || active_[i];
    if (active_[i]) continue;
    const double steepness = std::abs(term.steepness_s_per_m);
    saturated_steepness_ = saturated_steepness_ == 0 ? steepness : std::min(saturated_steepness_, steepness);
    constant_mu_ += term.height * std::copysign(1.0, term.steepness_s_per_m * slip_m_per_s);
  }
  falls_ = law.friction.falling.height != 0 && !sticks_ && !poised;
  if (falls_) {
    const double steepness = law.friction.falling.saturating_steepness_s_per_m();
    falls_ = steepness * std::abs(slip_m_per_s) < saturated_at_start;
    if (!falls_) saturated_steepness_ = steepness;
    varies_ = varies_ || falls_;
  }
  turned_mu_ = Twin{-constant_mu_, constant_mu_};
}

void ContactSeries::follow(const Creep& creep) {
  creep_ = &creep;
  sticks_ = true;
  varies_ = false;
  constant_mu_ = saturated_steepness_ = 0;
  turned_mu_ = Twin{};
}

double ContactSeries::turn_rate() const {
  return law_->annular
             ? (normal_[0][0] * velocity_[0][1] - normal_[0][1] * velocity_[0][0]) * inverse_length()
             : 0;
}

Twin ContactSeries::force_term(int k) { return law_->annular ? annular_term(k) : flat_term(k); }

/// The slip of a flat contact changes with t . d''. At an annular stop d1 d2'' - d2 d1'' = (s r)', where the
/// sliding speed s is constant unless the contact creeps. Among the products of order k, the one with
/// coefficient k of d'' is the unknown.
double ContactSeries::keeping_term(int k) const {
  if (!law_->annular) return creep_ ? (k + 1) * creep_->sliding()[k + 1] : 0;
  double rest = 0;
  if (creep_) {
    for (int j = 0; j <= k + 1; ++j) rest += length_.number(j) * creep_->sliding()[k + 1 - j];
    rest *= k + 1;
  } else {
    rest = sliding_speed_ * length_rate_.number(k);
  }
  for (int j = 1; j <= k; ++j)
    rest -= distance_[j][0] * acceleration_[k - j][1] - distance_[j][1] * acceleration_[k - j][0];
  return rest * inverse_length();
}

void ContactSeries::hold(int k, double force_n, Twin acceleration) {
  holding_.set(k, force_n);
  acceleration_.set(k, acceleration);
}

/// Adds coefficient k of mu from coefficient k of the slip.
void ContactSeries::add_slip_term(double slip, int k) {
  double mu = law_->friction.viscous_s_per_m * slip + (k == 0 ? constant_mu_ : 0);
  for (std::size_t i = 0; i < law_->friction.count; ++i) {
    if (!active_[i]) continue;
    const auto& term = law_->friction.tanh[i];
    tanh_[i].add_term(term.steepness_s_per_m, slip, k);
    mu += term.height * tanh_[i].y[k];
  }
  if (falls_) {
    const contact::Falling& falling = law_->friction.falling;
    fall_.add_term(falling.exponent, slip_sign_ * falling.steepness_s_per_m * slip, k);
    mu += slip_sign_ * falling.height * fall_.y[k];
  }
  mu_.set(k, mu);
}

double ContactSeries::friction_slope_term(int k) const {
  double slope = k == 0 ? law_->friction.viscous_s_per_m : 0;
  for (std::size_t i = 0; i < law_->friction.count; ++i) {
    const auto& term = law_->friction.tanh[i];
    if (active_[i]) slope += term.height * term.steepness_s_per_m * tanh_[i].z[k];
  }
  if (falls_) slope -= law_->friction.falling.height * law_->friction.falling.steepness_s_per_m * fall_.z[k];
  return slope * law_->slip_scale_m_per_s;
}

Twin ContactSeries::flat_term(int k) {
  const double spring = law_->stiffness * (distance_[k][0] - (k == 0 ? law_->clearance : 0));
  const double total = spring_factor_[0] * spring + damper_[0] * velocity_[k][0];
  if (!varies_) return Twin{total, constant_mu_ * spring};
  load_.set(k, Twin{spring, 0});
  sliding_.set(k, velocity_[k][1]);
  add_slip_term(law_->slip_scale_m_per_s * sliding_[k] + (k == 0 ? law_->surface_speed_m_per_s : 0), k);
  return Twin{total, product_term(mu_, load_, k)[0]};
}

/// Coefficient k of the normal n from r n = d, then of r' = n . d', and, if `damped`, of r' n, which is
/// returned. r must be known up to k.
template <bool damped>
Twin ContactSeries::normal_and_rate(int k) {
  if (k == 0) {
    const Twin square = distance_[0] * distance_[0];
    const double length = std::sqrt(sum_of(square)[0]);
    inverse_length_ = both(1 / length);
    length_.set(0, length);
    normal_.set(0, distance_[0] * inverse_length_);
    length_rate_.set(0, sum_of(normal_[0] * velocity_[0]));
    return damped ? length_rate_[0] * normal_[0] : Twin{};
  }
  // Only the last products use the newest coefficients: the other terms need not wait for them.
  Twin by_length[2]{}, by_velocity[2]{}, by_rate[2]{};
  const auto add = [&](int j, int half) {
    const Twin n = normal_[k - j];
    by_length[half] += length_[j] * n;
    by_velocity[half] += velocity_[j] * n;
    if constexpr (damped) by_rate[half] += length_rate_[j] * n;
  };
  int j = k - 1;
  for (; j > 1; j -= 2) {
    add(j, 0);
    add(j - 1, 1);
  }
  if (j == 1) add(j, 0);
  const Twin normal =
      (distance_[k] - (by_length[0] + by_length[1] + length_[k] * normal_[0])) * inverse_length_;
  const Twin rate =
      sum_of(by_velocity[0] + by_velocity[1] + velocity_[k] * normal_[0] + velocity_[0] * normal);
  normal_.set(k, normal);
  length_rate_.set(k, rate);
  if constexpr (!damped) return Twin{};
  return by_rate[0] + by_rate[1] + length_rate_[0] * normal + rate * normal_[0];
}

template Twin ContactSeries::normal_and_rate<false>(int);  // RegularContact needs it, too

/// The force is F n + mu S t with normal force F, spring force S = K (r - C), and t = n turned by a quarter
/// turn. S n = K (d - C n); with a damper, F n includes d r' n.
Twin ContactSeries::annular_term(int k) {
  const Twin damping = damper_[0] == 0 ? normal_and_rate<false>(k) : damper_ * normal_and_rate<true>(k);
  length_.set(k + 1, length_rate_[k] * numerics::one_over_twice(k + 1));
  const Twin load = stiffness_ * (distance_[k] - clearance_ * normal_[k]);
  Twin force = spring_factor_ * load + damping;
  if (!sticks_ && !varies_) return force + turned_mu_ * numerics::swapped(load);
  if (sticks_) return with_holding(force, k);
  load_.set(k, load);
  add_sliding_term(k);
  add_slip_term(law_->slip_scale_m_per_s * sliding_[k] + (k == 0 ? law_->surface_speed_m_per_s : 0), k);
  return force + quarter_turned(product_term(mu_, load_, k));
}

Twin ContactSeries::with_holding(Twin force, int k) {
  if (k > 0) return force + quarter_turned(sum_of_products(holding_, normal_, k, 0, k - 1));
  sliding_speed_ = normal_[0][0] * velocity_[0][1] - normal_[0][1] * velocity_[0][0];
  return force;
}

/// Sliding speed d' . t = n1 d2' - n2 d1'.
void ContactSeries::add_sliding_term(int k) {
  Twin sum{};
  for (int j = 0; j <= k; ++j) {
    const Twin v = velocity_[k - j];
    sum += normal_[j] * numerics::swapped(v);
  }
  sliding_.set(k, sum[0] - sum[1]);
}

void ContactSeries::make_sliding(int order) {
  if (varies_ || sliding_made_) return;
  sliding_made_ = true;
  for (int k = 0; k < order; ++k) {
    if (law_->annular) {
      add_sliding_term(k);
    } else {
      sliding_.set(k, velocity_[k][1]);
    }
  }
}

double ContactSeries::slip_term(int k) const {
  return law_->slip_scale_m_per_s * sliding_[k] + (k == 0 ? law_->surface_speed_m_per_s : 0);
}

void ContactSeries::put_penetration(int order, double* to) const {
  if (law_->annular && mode_ == Mode::open) {
    std::copy_n(open_penetration_.begin(), order + 1, to);
    return;
  }
  const PlaneSeries& series = law_->annular ? length_ : distance_;
  for (int k = 0; k <= order; ++k) to[k] = series.number(k);
  to[0] -= law_->clearance;
}

void ContactSeries::make_open_penetration(int order) {
  if (!law_->annular) return;
  const double clearance = law_->clearance, share = 1 / (2 * clearance);
  for (int k = 0; k <= order; ++k) {
    const int half = k / 2;
    Twin sum = both(2) * sum_of_products(distance_, distance_, k, 0, (k - 1) / 2);
    if (k == 0) sum = Twin{};
    if (k % 2 == 0) sum += distance_[half] * distance_[half];
    const double square = sum_of(sum)[0] - (k == 0 ? clearance * clearance : 0);
    open_penetration_[static_cast<std::size_t>(k)] = share * square;
  }
}

}  // namespace rubsweep::integrate::taylor
