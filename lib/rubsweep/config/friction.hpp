#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/model/friction.hpp"

namespace rubsweep::config {

/// `friction` of a stop: {stribeck: [g1, ..., g6]}, {static, kinetic, peak_speed_m_per_s,
/// settle_speed_m_per_s, viscous_s_per_m}, {coefficient: mu}, or the word `none`.
model::Friction read_friction(const Value& value);
void print_friction(Printer& printer, const model::Friction& friction);

}  // namespace rubsweep::config
