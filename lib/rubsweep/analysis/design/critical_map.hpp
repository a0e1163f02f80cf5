#pragma once

#include <span>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::design {

/// Undamped critical speeds of a rotor whose bearings all have one stiffness.
struct CriticalSpeedsAt {
  double stiffness_n_per_m = 0;
  std::vector<double> speed_hz;  ///< speeds of synchronous forward whirl, ascending
};

/// Undamped critical speed map: the first `modes` critical speeds, or fewer where there are fewer, for each
/// stiffness > 0. Bearings have this stiffness along x and y and nothing else; seals, damping, cross-coupling
/// and the fluid in supports are left out. Pedestals and housings keep the mean of x and y. Empty where no
/// support of the kit is a bearing. Throws ConfigError where a stiffness is too small or too large for the
/// rounding of the shaft.
std::vector<CriticalSpeedsAt> critical_map(const model::RotorKit& kit, const std::vector<double>& stations_m,
                                           std::span<const double> stiffness_n_per_m, int modes);

}  // namespace rubsweep::design
