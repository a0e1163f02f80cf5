#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"

namespace rubsweep::integrate::exact::modes {

/// Bounds on the rate of a contact's sliding speed while every touching contact is released.
struct ReleasedSlip {
  /// Bound per size of the free vibration of the structure without contact, as for a mode with pairs.
  Eigen::RowVectorXd sliding_rate_bound;
  /// Contributions of friction, per contact and per initial penetration: the immediate contribution, and the
  /// contribution per second by the vibration that it has excited so far.
  std::vector<double> friction_rate, friction_swing;
};

/// Bounds for contact `i` of a joint mode in which no contact is clamped or sprung, over at most
/// `longest_step_s`. Such a mode has no modal form. In full matrices the penetration is a small difference of
/// large components, for which bounds by components are useless. But only friction f acts between released
/// contacts, so that the structure moves as without contact, with f as an external force:
///
///     row . x' = row A x + row B f,   x(t) = e^{A t} x(0) + int_0^t e^{A (t - s)} B f(s) ds,
///
/// and the modal form of the structure without contact bounds e^{A t}. Empty if the structure has no modal
/// form.
std::optional<ReleasedSlip> released_slip(const CommonToModes& common,
                                          const std::vector<contact::Mode>& modes, std::size_t i,
                                          double longest_step_s);

}  // namespace rubsweep::integrate::exact::modes
