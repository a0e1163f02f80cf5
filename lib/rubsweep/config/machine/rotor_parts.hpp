#pragma once

#include "rubsweep/config/yaml/section.hpp"
#include "rubsweep/model/rotor_kit.hpp"

namespace rubsweep::config::machine {

/// Numbers of a disc that follow from its `geometry`, where that is given: outer_diameter_m,
/// inner_diameter_m, width_m and density_kg_per_m3 in place of mass and inertias. To be called before these
/// are read.
void read_disc_geometry(yaml::Section& section, model::Disc& disc);

/// `fault` of a support: impulse_ns, angle_deg, phase_deg, and `multiple` or `bearing`, from which that
/// follows: defect (outer_race, inner_race, ball or cage), pitch_diameter_m, ball_diameter_m, balls,
/// contact_angle_deg.
model::BearingFault read_bearing_fault(const yaml::Value& value);

}  // namespace rubsweep::config::machine
