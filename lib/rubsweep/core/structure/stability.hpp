#pragma once

#include <optional>

#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::structure {

/// Whether a proof holds that no free vibration mass q'' + damping q' + stiffness q = 0 grows: a stiffness
/// that is symmetric and positive definite holds energy, and the symmetric part of the damping takes none in.
/// A skew part of the damping, as of gyroscopic moments, does no work. `rounding`: share of the sizes on the
/// diagonals below which a number counts as rounding. Without the proof vibrations may decay all the same.
bool dissipates(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& damping, const Eigen::MatrixXd& stiffness,
                double rounding);

/// Largest growth rate, per second, of a free vibration of a rotor that touches nothing at this speed; 0 or
/// less where all decay, and 0 where it is positive by no more than rounding may be the cause of.
/// `speed_rad_per_s` >= 0.
double growth_per_s(const Assembly& assembly, double speed_rad_per_s);
/// Growth of a system whose matrices hold for one speed already.
double growth_per_s(const LinearSystem& system);

/// Whether such a vibration grows.
bool grows(const Assembly& assembly, double speed_rad_per_s);
bool grows(const LinearSystem& system);

/// The lowest speed up to `highest_hz` from which on a free vibration grows, found on a grid of 200 speeds
/// and bisected to 1e-9 of it: empty where there is none, 0 where the rotor is unstable at rest.
std::optional<double> instability_hz(const Assembly& assembly, double highest_hz);

}  // namespace rubsweep::structure
