#pragma once

#include <string_view>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Keys for the constants k and c of a Jeffcott rotor, in place of natural_frequency_hz and damping_ratio.
inline constexpr std::string_view rotor_stiffness_key = "stiffness_n_per_m",
                                  rotor_damping_key = "damping_ns_per_m";

/// Reads `rotor` of any kind into machine.rotor.
void read_rotor(const yaml::Value& value, model::Machine& machine);
keys::Form rotor_form();
void print_rotor(yaml::Printer& printer, const model::Machine& machine,
                 MatrixPrint matrices = MatrixPrint::inside);

}  // namespace rubsweep::config::machine
