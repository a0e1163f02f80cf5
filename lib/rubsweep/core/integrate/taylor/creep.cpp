#include "rubsweep/core/integrate/taylor/creep.hpp"

#include <cmath>

#include "rubsweep/core/integrate/taylor/contact_series.hpp"

namespace rubsweep::integrate::taylor {

void Creep::begin(const ContactLaw& law, double slip_m_per_s) {
  law_ = &law;
  for (int k = 0; k <= numerics::most_taylor_order + 1; ++k) set_slip(k, k == 0 ? slip_m_per_s : 0);
}

void Creep::set_slip(int k, double slip_m_per_s) {
  slip_.set(k, slip_m_per_s);
  sliding_.set(k, (slip_m_per_s - (k == 0 ? law_->surface_speed_m_per_s : 0)) / law_->slip_scale_m_per_s);
}

/// Solves mu(slip) = coefficient by Newton's iteration from the present slip.
bool Creep::find_start(double coefficient) {
  constexpr int most_iterations = 10;
  constexpr double settled = 1e-14;
  double slip = slip_[0];
  for (int i = 0; i < most_iterations; ++i) {
    double value = law_->friction.viscous_s_per_m * slip, slope = law_->friction.viscous_s_per_m, size = 0;
    for (std::size_t t = 0; t < law_->friction.count; ++t) {
      const auto& [height, steepness] = law_->friction.tanh[t];
      const double share = std::tanh(steepness * slip), inverse = 1 / std::cosh(steepness * slip);
      value += height * share;
      slope += height * steepness * inverse * inverse;
      size += std::abs(height);
    }
    const double correction = (coefficient - value) / slope;
    if (!(slope > 0) || !std::isfinite(correction)) return false;
    slip += correction;
    if (std::abs(coefficient - value) > settled * size) continue;
    change_[0] = (slip - slip_[0]) / law_->slip_scale_m_per_s;
    set_slip(0, slip);
    return true;
  }
  return false;
}

bool Creep::sweep(const ContactSeries& contact, int order) {
  const auto& friction = law_->friction;
  load_.set(0, law_->stiffness * contact.penetration_term(0));
  coefficient_.set(0, contact.holding().number(0) / load_[0]);
  if (!(load_[0] > 0) || !find_start(coefficient_[0])) return false;
  for (int k = 0; k < order; ++k) {
    if (k > 0) {
      load_.set(k, law_->stiffness * contact.penetration_term(k));
      const double inner = inner_sum(load_, coefficient_, k) + load_[k] * coefficient_[0];
      coefficient_.set(k, (contact.holding().number(k) - inner) / load_[0]);
      // Coefficient k of mu is slope times that of the slip, plus a rest from the earlier coefficients.
      double rest = 0;
      for (std::size_t t = 0; t < friction.count; ++t) {
        tanh_[t].add_term(friction.tanh[t].steepness_s_per_m, 0, k);
        rest += friction.tanh[t].height * tanh_[t].y[k];
      }
      const double slip = (coefficient_[k] - rest) * law_->slip_scale_m_per_s / slope_[0];
      change_[static_cast<std::size_t>(k)] = (slip - slip_[k]) / law_->slip_scale_m_per_s;
      set_slip(k, slip);
    }
    double slope = k == 0 ? friction.viscous_s_per_m : 0;
    for (std::size_t t = 0; t < friction.count; ++t) {
      tanh_[t].add_term(friction.tanh[t].steepness_s_per_m, slip_[k], k);
      slope += friction.tanh[t].height * friction.tanh[t].steepness_s_per_m * tanh_[t].z[k];
    }
    slope_.set(k, slope * law_->slip_scale_m_per_s);
  }
  return slope_[0] > 0;
}

}  // namespace rubsweep::integrate::taylor
