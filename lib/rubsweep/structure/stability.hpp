#pragma once

#include <optional>

#include "rubsweep/structure/assembly.hpp"

namespace rubsweep::structure {

/// Largest growth rate, per second, of a free vibration of a rotor that touches nothing at this speed; 0 or
/// less where all decay. `speed_rad_per_s` >= 0.
double growth_per_s(const Assembly& assembly, double speed_rad_per_s);

/// Whether such a vibration grows. Growth below a billionth of the fastest rate counts as rounding.
bool grows(const Assembly& assembly, double speed_rad_per_s);
/// The same of a system whose matrices are those of one speed already.
bool grows(const LinearSystem& system);

/// The lowest speed up to `highest_hz` from which on a free vibration grows, found on a grid of 200 speeds
/// and bisected to 1e-9 of it: empty where there is none, 0 where the rotor is unstable at rest.
std::optional<double> instability_hz(const Assembly& assembly, double highest_hz);

}  // namespace rubsweep::structure
