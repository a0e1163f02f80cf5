#pragma once

#include <array>
#include <string_view>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/shaft_segment.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

inline constexpr std::size_t most_layers = 16;
inline constexpr std::array<std::string_view, 3> disc_inertias{"mass_kg", "polar_inertia_kg_m2",
                                                               "diametral_inertia_kg_m2"};
/// In the order of model::BearingDefect.
inline constexpr std::array<std::string_view, 4> bearing_defects{"outer_race", "inner_race", "ball", "cage"};

/// Keys of a segment of `rotor.shaft` beside its numbers: shear_coefficient (cowper, hutchinson or none),
/// rotary_inertia and gyroscopic (on or off), and `layers`, a list of sections of the same length.
void read_segment(yaml::Section& section, model::ShaftSegment& segment);
void print_segment(yaml::Printer& printer, const model::ShaftSegment& segment);

/// `bow` of a rotor kit: {mode, amplitude_m} or {position_m, deflection_m}, two lists; phase_deg. `places`
/// are those along the shaft.
model::Bow read_bow(const yaml::Value& value, const model::Range& places);
void print_bow(yaml::Printer& printer, const model::Bow& bow);

/// Numbers of a disc that follow from its `geometry`, where that is given: outer_diameter_m,
/// inner_diameter_m, width_m and density_kg_per_m3 in place of mass and inertias. To be called before these
/// are read.
void read_disc_geometry(yaml::Section& section, model::Disc& disc);

/// `fault` of a support: impulse_ns, angle_deg, phase_deg, and `multiple` or `bearing`, from which that
/// follows: defect (outer_race, inner_race, ball or cage), pitch_diameter_m, ball_diameter_m, balls,
/// contact_angle_deg.
model::BearingFault read_bearing_fault(const yaml::Value& value);

}  // namespace rubsweep::config::machine
