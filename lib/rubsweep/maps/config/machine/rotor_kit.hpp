#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// Reads the keys of `rotor` for kind: rotor_kit.
model::RotorKit read_rotor_kit(yaml::Section& section);
/// Reads the keys of a kit that files of other tools do not have. Call it when the shaft is known.
void read_kit_rest(yaml::Section& section, model::RotorKit& kit);
std::vector<keys::Key> kit_rest_keys();

/// Whether this number of a support is a coefficient, which a table may replace.
inline bool is_coefficient(std::string_view name) {
  return name != "position_m" && !name.starts_with("angular");
}

/// Reads the list `supports`. Shaft and housings must be known.
void read_supports(const yaml::Value& supports, model::RotorKit& kit);

/// Adds a problem where tables of supports have no speed in common, or exclude a key of `section`.
void refuse_tables(const yaml::Value& supports, yaml::Section& section, const model::RotorKit& kit);

/// Adds a problem to `supports` where they leave the shaft or a housing free to move.
void refuse_loose_shaft(const yaml::Value& supports, const model::RotorKit& kit);

/// The keys that read_rotor_kit reads.
std::vector<keys::Key> rotor_kit_keys();

void print_rotor_kit(yaml::Printer& printer, const model::RotorKit& kit,
                     MatrixPrint matrices = MatrixPrint::inside);

/// Allowed positions along the shaft: between its ends.
model::Range places(const model::RotorKit& kit);

}  // namespace rubsweep::config::machine
