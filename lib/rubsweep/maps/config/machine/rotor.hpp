#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
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

/// Reads the keys of `rotor` for kind: ross. `file` names a TOML or JSON file of ROSS
/// (github.com/petrobras/ross), relative to the file of the configuration. `unbalance` is a list of discs by
/// their tags. The remaining keys are those that a rotor kit has but a ROSS file does not (read_kit_rest).
/// The result is a rotor kit with the elements of the file.
model::RotorKit read_ross_rotor(yaml::Section& section);
std::vector<keys::Key> ross_keys();

}  // namespace rubsweep::config::machine
