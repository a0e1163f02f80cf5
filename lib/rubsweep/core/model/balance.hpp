#pragma once

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::model {

/// Unbalance of a rotor per metre of a cell's eccentricity, in kg. For a Jeffcott rotor this is its mass. For
/// a rotor kit it is the sum of mass_kg |eccentricity_ratio| over its discs; phases are ignored, so that
/// opposite unbalances do not cancel. 0 where all discs are centred.
double unbalanced_mass_kg(const Machine& machine);

/// Rotor mass to which a balance grade refers: for a rotor kit, shaft and discs.
double rotor_mass_kg(const Machine& machine);

/// Divisor that turns an unbalance in g mm into the eccentricity of a cell in metres.
double g_mm_per_metre(const Machine& machine);

/// Divisor that turns a balance quality grade G of ISO 21940-11 (mm/s) into the eccentricity of a cell in
/// metres. The permitted unbalance is G rotor_mass_kg / w, w being the angular speed of `rated_speed_hz`; for
/// a Jeffcott rotor e = G / w.
double grade_per_metre(const Machine& machine, double rated_speed_hz);

}  // namespace rubsweep::model
