#pragma once

#include <optional>

#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::structure {

/// Whether it is proven that no free vibration mass q'' + damping q' + stiffness q = 0 grows. The proof holds
/// if the stiffness is symmetric and positive definite, so that it stores energy, and the symmetric part of
/// the damping supplies none. A skew part of the damping (gyroscopic moments) does no work. `rounding`: share
/// of the diagonal below which a number counts as rounding. False proves nothing: vibrations may still decay.
bool dissipates(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& damping, const Eigen::MatrixXd& stiffness,
                double rounding);

/// Largest growth rate, per second, of a free vibration of a rotor without contact at this speed. It is 0 or
/// less where all decay; a positive rate that rounding could explain counts as 0. `speed_rad_per_s` >= 0.
double growth_per_s(const Assembly& assembly, double speed_rad_per_s);
/// Growth rate of a system whose matrices already hold for one speed.
double growth_per_s(const LinearSystem& system);

bool grows(const Assembly& assembly, double speed_rad_per_s);  ///< Whether a free vibration grows at a speed.
bool grows(const LinearSystem& system);

/// Lowest speed up to `highest_hz` at which a free vibration begins to grow, found on a grid of 200 speeds
/// and by bisection to 1e-9 of a grid step. Empty where there is none, 0 where the rotor is unstable at rest.
std::optional<double> instability_hz(const Assembly& assembly, double highest_hz);

}  // namespace rubsweep::structure
