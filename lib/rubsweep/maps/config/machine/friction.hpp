#pragma once

#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// `friction` of a stop: {stribeck: [g1, ..., g6]}, {static, kinetic, peak_speed_m_per_s,
/// settle_speed_m_per_s, viscous_s_per_m}, {coefficient: mu}, or the word `none`.
model::Friction read_friction(const yaml::Value& value);
keys::Form friction_form();
void print_friction(yaml::Printer& printer, const model::Friction& friction);

}  // namespace rubsweep::config::machine
