#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"

namespace rubsweep::integrate::exact::modes {

/// Bounds on the rate of a contact's sliding speed while every touching contact is released.
struct ReleasedSlip {
  /// By the sizes of the free vibration of the structure without any contact, as for a mode of pairs.
  Eigen::RowVectorXd sliding_rate_bound;
  /// Contributions of friction, per contact and per penetration at the start: the immediate one, and the rate
  /// per second of the one through the vibration that it has excited by then.
  std::vector<double> friction_rate, friction_swing;
};

/// For contact `i` of a joint mode in which no contact is clamped or sprung, over at most `longest_step_s`.
/// Such a mode has no modal form, and in full matrices the penetration is a small difference of large
/// components, which a bound by components cannot see. But only friction f acts between released contacts, so
/// that the structure moves as without contact, with f as a force from outside:
///
///     row . x' = row A x + row B f,   x(t) = e^{A t} x(0) + int_0^t e^{A (t - s)} B f(s) ds,
///
/// and e^{A t} of the structure without contact is bounded by its modal form. Empty where it has none.
std::optional<ReleasedSlip> released_slip(const CommonToModes& common,
                                          const std::vector<contact::Mode>& modes, std::size_t i,
                                          double longest_step_s);

}  // namespace rubsweep::integrate::exact::modes
