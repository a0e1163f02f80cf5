#pragma once

#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response::proof {

/// The scene with equal stops made one: contacts of the same place of the rotor with the same wall at the
/// same clearance on rigid casings, whose dampers are the same share of their stiffness and whose friction is
/// the same. Their guards are one function of the state, so that they change mode together, and the sum of
/// their forces is that of one stop with the sum of their stiffnesses and dampings: no motion differs but for
/// rounding. Stops with a casing each are two bodies and stay two.
scene::Scene with_equal_stops_as_one(scene::Scene scene);

}  // namespace rubsweep::response::proof
