#pragma once

#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::structure {

/// The linear system of an assembly at one speed of the shaft: gyroscopic moments, damping that turns with the shaft,
/// and supports by their tables, which must reach the speed.
LinearSystem system_at(const Assembly& assembly, double speed_rad_per_s);

}  // namespace rubsweep::structure
