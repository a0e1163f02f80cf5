#pragma once

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// Puts the scene into the start state of its machine, if the machine gives one. Given numbers replace those
/// of the current state (a machine with a start has no kick). With `at_rest` everything is in its unloaded
/// position. Otherwise, coordinates of a Jeffcott rotor and of casings are set directly. The observed point
/// of a rotor kit is displaced as by a static force at this point, which bends the shaft, and gets its
/// velocity as by an impulse there. Throws ConfigError where the structure cannot be brought into this state.
void start_in_given_state(Scene& scene, const PreparedMachine& prepared);

}  // namespace rubsweep::scene
