#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// The keys of `rotor` beside kind: rotor_kit.
model::RotorKit read_rotor_kit(yaml::Section& section);
/// Keys of a kit that no file of another tool has. To be called when the shaft is known.
void read_kit_rest(yaml::Section& section, model::RotorKit& kit);
std::vector<keys::Key> kit_rest_keys();

/// Whether a table may stand for this number of a support.
inline bool is_coefficient(std::string_view name) {
  return name != "position_m" && !name.starts_with("angular");
}

/// The list `supports`; shaft and housings must be known.
void read_supports(const yaml::Value& supports, model::RotorKit& kit);

/// A problem of supports whose tables have no speed in common, or exclude what stands in `section` beside
/// them.
void refuse_tables(const yaml::Value& supports, yaml::Section& section, const model::RotorKit& kit);

/// A problem of `supports` where they do not hold the shaft.
void refuse_loose_shaft(const yaml::Value& supports, const model::RotorKit& kit);

/// The keys that read_rotor_kit reads.
std::vector<keys::Key> rotor_kit_keys();

void print_rotor_kit(yaml::Printer& printer, const model::RotorKit& kit,
                     MatrixPrint matrices = MatrixPrint::inside);

/// Allowed positions along the shaft: between its ends.
model::Range places(const model::RotorKit& kit);

}  // namespace rubsweep::config::machine
