#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/model/rotor.hpp"

namespace rubsweep::config {

/// `rotor`: {kind: jeffcott, mass_kg, natural_frequency_hz, damping_ratio}, all required.
model::JeffcottRotor read_rotor(const Value& value);
void print_rotor(Printer& printer, const model::JeffcottRotor& rotor);

}  // namespace rubsweep::config
