#pragma once

#include <span>
#include <vector>

#include "rubsweep/analysis/linear/whirl_modes.hpp"

namespace rubsweep::linear {

/// A mode at one speed, as it is needed to follow it.
struct FollowedMode {
  double speed_hz = 0;
  WhirlMode mode;
};

/// Points at which the whirl frequency of a followed mode equals the shaft speed, located to rounding between
/// its points, which ascend by speed. Throws SolverError where the mode is lost between two of them.
std::vector<FollowedMode> critical_points(const WhirlProblem& problem, std::span<const FollowedMode> curve);

}  // namespace rubsweep::linear
