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
/// Words for the kinds of bearing defects, in the order of model::BearingDefect.
inline constexpr std::array<std::string_view, 4> bearing_defects{"outer_race", "inner_race", "ball", "cage"};

/// Reads those keys of a segment of `rotor.shaft` that are more than a number, and its layers.
void read_segment(yaml::Section& section, model::ShaftSegment& segment);
void print_segment(yaml::Printer& printer, const model::ShaftSegment& segment);

/// Reads `bow` of a rotor kit; `places` is the allowed range of positions along the shaft, in m.
model::Bow read_bow(const yaml::Value& value, const model::Range& places);
void print_bow(yaml::Printer& printer, const model::Bow& bow);

/// Computes mass and inertias of a disc from its `geometry`, if given. Call it before mass and inertias are
/// read.
void read_disc_geometry(yaml::Section& section, model::Disc& disc);

/// Reads `fault` of a support: `multiple`, or the `bearing` from which it is computed.
model::BearingFault read_bearing_fault(const yaml::Value& value);

}  // namespace rubsweep::config::machine
