#pragma once

#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/model/rotor_kit.hpp"

namespace rubsweep::config::machine {

/// `bow` of a rotor kit: {mode, amplitude_m} or {position_m, deflection_m}, two lists; phase_deg. `places`
/// are those along the shaft.
model::Bow read_bow(const yaml::Value& value, const model::Range& places);
void print_bow(yaml::Printer& printer, const model::Bow& bow);

}  // namespace rubsweep::config::machine
