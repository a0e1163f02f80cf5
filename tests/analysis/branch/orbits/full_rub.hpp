#pragma once

namespace rubsweep::branch::orbits {

/// Damping ratio of the rotor in full annular rub, and stiffness of the ring / stiffness of the shaft.
inline constexpr double zeta = 0.05, stiffness = 4;

}  // namespace rubsweep::branch::orbits
