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

/// Keys of a segment of `rotor.shaft` beside its numbers, with its layers.
void read_segment(yaml::Section& section, model::ShaftSegment& segment);
void print_segment(yaml::Printer& printer, const model::ShaftSegment& segment);

/// `bow` of a rotor kit; `places` are those along the shaft.
model::Bow read_bow(const yaml::Value& value, const model::Range& places);
void print_bow(yaml::Printer& printer, const model::Bow& bow);

/// Mass and inertias of a disc, where they follow from its `geometry`. To be called before these are read.
void read_disc_geometry(yaml::Section& section, model::Disc& disc);

/// `fault` of a support: with `multiple`, or with the `bearing` from which that follows.
model::BearingFault read_bearing_fault(const yaml::Value& value);

}  // namespace rubsweep::config::machine
