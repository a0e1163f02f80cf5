#pragma once

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// Puts the scene into the state that its machine gives, if it gives one: what is given replaces what the
/// state has there (a machine with a start has no kick). At rest everything stands in the unloaded position.
/// Else a Jeffcott rotor and a casing are bodies
/// whose coordinates are set. Of a rotor kit the observed point is moved, the shaft following as a static
/// force there would bend it, and set in motion as an impulse there would move it. Throws ConfigError where
/// the structure cannot be brought there.
void start_in_given_state(Scene& scene, const PreparedMachine& prepared);

}  // namespace rubsweep::scene
