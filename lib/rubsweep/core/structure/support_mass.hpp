#pragma once

#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {

/// Gives every motion of the shaft a mass that is not negative. Fluid may take away more mass than a short
/// element has, and a motion of the element alone would then grow at a rate that says nothing about the
/// rotor. Such a mode, K v = -w^2 M v, gets the opposite mass and vibrates at w; all other modes stay as they
/// are. Throws ConfigError where w is in the range of modes that the kit needs.
void keep_mass_positive(const model::RotorKit& kit, BeamShaft& shaft);

}  // namespace rubsweep::structure
