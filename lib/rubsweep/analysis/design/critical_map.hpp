#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/model/machine.hpp"

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

/// First undamped critical speed on rigid bearings, which is the natural frequency of a Jeffcott rotor. Empty
/// where no support is a bearing, where no stiffness is rigid, or where matrices do not tell shaft and
/// bearings apart. Precise to 1e-6.
std::optional<double> rigid_critical_hz(const model::Machine& machine);

}  // namespace rubsweep::design
