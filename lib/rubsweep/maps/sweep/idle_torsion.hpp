#pragma once

#include <string>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::sweep {

/// Why the torsion of a rotor kit hardly changes the motion, one line for people; empty where the rotor has
/// none or where it may. Twist acts through the slip, and friction that is saturated does not ask how large
/// that is; and it turns the unbalance. The estimate: a hit of twice the kick's impulse changes the surface
/// speed by mu 2 I R^2 / J, which must leave the slip of the slowest shaft where every friction is saturated,
/// and which changes speed and direction of the unbalance by a hundredth at most.
std::string why_torsion_is_idle(const scene::PreparedMachine& prepared, double slowest_hz);

}  // namespace rubsweep::sweep
