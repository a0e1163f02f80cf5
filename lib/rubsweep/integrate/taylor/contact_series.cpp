#include "rubsweep/integrate/taylor/contact_series.hpp"

#include <algorithm>
#include <cmath>

namespace rubsweep::integrate::taylor {

using contact::Mode;
using numerics::product_term;
using numerics::square_term;

void ContactSeries::begin(const ContactLaw& law, Mode mode, double slip_m_per_s, contact::Slip way) {
  law_ = &law;
  mode_ = mode;
  spring_factor_ = contact::law_of(mode).spring;
  damper_ = law.damper(mode);
  sliding_made_ = false;
  saturated_steepness_ = 0;
  const bool dry = law.friction.dry > 0;
  sticks_ = dry && mode != Mode::open && way == contact::Slip::sticking;
  slip_sign_ = dry ? contact::sign_of(way) : std::copysign(1.0, slip_m_per_s);
  constant_mu_ = dry ? law.friction.dry * slip_sign_ : law.friction.constant;
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
}

double ContactSeries::turn_rate() const {
  return law_->annular ? (d1[0] * d2[1] - d2[0] * d1[1]) / s_[0] : 0;
}

ContactSeries::Force ContactSeries::force_term(int k) {
  return law_->annular ? annular_term(k) : flat_term(k);
}

/// A flat contact's slip changes as t . d''. Around the rotor d1 d2'' - d2 d1'' = s r', s being the sliding
/// speed: of all its products of order k, the one with d'' of that order is looked for.
double ContactSeries::keeping_term(int k) const {
  if (!law_->annular) return 0;
  double rest = sliding_speed_ * (k + 1) * r_[k + 1];
  for (int j = 1; j <= k; ++j) rest -= d1[j] * a2_[k - j] - d2[j] * a1_[k - j];
  return rest * q_[0];
}

void ContactSeries::hold(int k, double force_n, double a1, double a2) {
  holding_.set(k, force_n);
  a1_.set(k, a1);
  a2_.set(k, a2);
  if (law_->annular) holding_over_length_.set(k, product_term(holding_, q_, k));
}

/// Coefficient k of mu from that of the slip.
void ContactSeries::add_slip_term(double slip, int k) {
  double mu = law_->friction.viscous_s_per_m * slip + (k == 0 ? constant_mu_ : 0);
  for (std::size_t i = 0; i < law_->friction.count; ++i) {
    if (!active_[i]) continue;
    const auto& term = law_->friction.tanh[i];
    tanh_[i].add_term(term.steepness_s_per_m, slip, k);
    mu += term.height * tanh_[i].y[k];
  }
  mu_.set(k, mu);
}

double ContactSeries::friction_slope_term(int k) const {
  double slope = k == 0 ? law_->friction.viscous_s_per_m : 0;
  for (std::size_t i = 0; i < law_->friction.count; ++i) {
    const auto& term = law_->friction.tanh[i];
    if (active_[i]) slope += term.height * term.steepness_s_per_m * tanh_[i].z[k];
  }
  return slope * law_->slip_scale_m_per_s;
}

ContactSeries::Force ContactSeries::flat_term(int k) {
  const double spring = law_->stiffness * (d1[k] - (k == 0 ? law_->clearance : 0));
  const double total = spring_factor_ * spring + damper_ * (k + 1) * d1[k + 1];
  if (!varies_) return {total, constant_mu_ * spring};
  spring_.set(k, spring);
  sliding_.set(k, (k + 1) * d2[k + 1]);
  add_slip_term(law_->slip_scale_m_per_s * sliding_[k] + (k == 0 ? law_->surface_speed_m_per_s : 0), k);
  return {total, product_term(mu_, spring_, k)};
}

/// With z = d1 + i d2, normal force F and spring force S the force is (F + i mu S) z / r. S / r = K (1 - C q)
/// and, where the damper works, F / r is that plus d r' q.
ContactSeries::Force ContactSeries::annular_term(int k) {
  if (k == 0) {
    s_.set(0, square_term(d1, 0) + square_term(d2, 0));
    r_.set(0, std::sqrt(s_[0]));
  }
  s_.set(k + 1, square_term(d1, k + 1) + square_term(d2, k + 1));
  q_.set(k, numerics::reciprocal_term(q_, r_, k));
  r_.set(k + 1, numerics::root_term(r_, s_[k + 1], k + 1, q_[0]));
  e_.set(k, law_->stiffness * ((k == 0 ? 1 : 0) - law_->clearance * q_[k]));
  Force force;
  double zx = 0, zy = 0;
  if (!damped() || varies_ || constant_mu_ != 0) {
    zx = product_term(e_, d1, k);
    zy = product_term(e_, d2, k);
  }
  if (damped()) {
    length_rate_.set(k, (k + 1) * r_[k + 1]);
    alpha_.set(k, spring_factor_ * e_[k] + damper_ * product_term(length_rate_, q_, k));
    force = {product_term(alpha_, d1, k), product_term(alpha_, d2, k)};
  } else {
    alpha_.set(k, spring_factor_ * e_[k]);
    force = {spring_factor_ * zx, spring_factor_ * zy};
  }
  if (sticks_) {
    if (k == 0) sliding_speed_ = (d1[0] * d2[1] - d2[0] * d1[1]) * q_[0];
    // f (-d2, d1) / r without f_k.
    double over = 0;
    for (int j = 0; j < k; ++j) over += holding_[j] * q_[k - j];
    double first = over * d2[0], second = over * d1[0];
    for (int j = 0; j < k; ++j) {
      first += holding_over_length_[j] * d2[k - j];
      second += holding_over_length_[j] * d1[k - j];
    }
    return {force.first - first, force.second + second};
  }
  if (!varies_) return {force.first - constant_mu_ * zy, force.second + constant_mu_ * zx};
  zx_.set(k, zx);
  zy_.set(k, zy);
  add_sliding_term(k);
  add_slip_term(law_->slip_scale_m_per_s * sliding_[k] + (k == 0 ? law_->surface_speed_m_per_s : 0), k);
  return {force.first - product_term(mu_, zy_, k), force.second + product_term(mu_, zx_, k)};
}

/// d' . t = (d1 d2' - d2 d1') / r.
void ContactSeries::add_sliding_term(int k) {
  v1_.set(k, (k + 1) * d1[k + 1]);
  v2_.set(k, (k + 1) * d2[k + 1]);
  cross_.set(k, product_term(d1, v2_, k) - product_term(d2, v1_, k));
  sliding_.set(k, product_term(cross_, q_, k));
}

void ContactSeries::make_sliding(int order) {
  if (varies_ || sliding_made_) return;
  sliding_made_ = true;
  for (int k = 0; k < order; ++k) {
    if (law_->annular) {
      add_sliding_term(k);
    } else {
      sliding_.set(k, (k + 1) * d2[k + 1]);
    }
  }
}

double ContactSeries::slip_term(int k) const {
  return law_->slip_scale_m_per_s * sliding_[k] + (k == 0 ? law_->surface_speed_m_per_s : 0);
}

void ContactSeries::make_open_penetration(int order) {
  if (!law_->annular) return;
  for (int k = 0; k <= order; ++k) s_.set(k, square_term(d1, k) + square_term(d2, k));
}

double ContactSeries::penetration_term(int k) const {
  if (!law_->annular) return d1[k] - (k == 0 ? law_->clearance : 0);
  if (mode_ != Mode::open) return r_[k] - (k == 0 ? law_->clearance : 0);
  return (s_[k] - (k == 0 ? law_->clearance * law_->clearance : 0)) / (2 * law_->clearance);
}

}  // namespace rubsweep::integrate::taylor
