#pragma once

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::model {

/// Unbalance of a rotor per metre of a cell's eccentricity, in kg: the mass of a Jeffcott rotor; of a rotor
/// kit the sum of mass_kg |eccentricity_ratio| of its discs, whatever their phases, so that discs that stand
/// off to opposite sides do not cancel. 0 where no disc stands off the axis.
double unbalanced_mass_kg(const Machine& machine);

/// Mass of the rotor that a balance grade is for: of a rotor kit its shaft and its discs.
double rotor_mass_kg(const Machine& machine);

/// Divisor of an unbalance in g mm that gives the eccentricity of a cell in metres.
double g_mm_per_metre(const Machine& machine);

/// The same for a balance quality grade G of ISO 21940-11 in mm/s: the unbalance that it permits is G
/// rotor_mass_kg / w, w the angular speed of `rated_speed_hz`; for a Jeffcott rotor e = G / w.
double grade_per_metre(const Machine& machine, double rated_speed_hz);

}  // namespace rubsweep::model
