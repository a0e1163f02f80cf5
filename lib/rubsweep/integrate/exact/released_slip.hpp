#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/contact/saturation.hpp"
#include "rubsweep/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::exact {

/// Bounds on the rate of a contact's sliding speed while every touching contact is released.
struct ReleasedSlip {
  /// By the sizes of the free vibration of the structure without any contact, as for a mode of pairs.
  Eigen::RowVectorXd sliding_rate_bound;
  /// What friction may add, per contact and per penetration at the start: at once, and by what it has moved
  /// after a second.
  std::vector<double> friction_rate, friction_swing;
};

/// For contact `i` of a joint mode in which no contact is clamped or sprung, over at most `longest_step_s`.
/// In full matrices the penetration is a small difference of large components, which a bound by components
/// cannot see. Between released contacts the structure is free but for friction f, which its modal form
/// without contacts can bound: row . x' = row A x + row B f with x(t) = e^{A t} x(0) + int e^{A (t - s)} B
/// f(s) ds. Empty where the structure has no modal form.
std::optional<ReleasedSlip> released_slip(const run::ScaledSystem<Eigen::Dynamic>& system,
                                          const std::vector<contact::SaturatedFriction>& friction,
                                          const std::vector<contact::Mode>& modes, std::size_t i,
                                          double longest_step_s);

}  // namespace rubsweep::integrate::exact
