#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/shaft_segment.hpp"
#include "rubsweep/core/model/support_table.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

model::RotorKit read_rotor_kit(yaml::Section& section);  ///< Reads the keys of `rotor` for kind: rotor_kit.
/// Reads the keys of a kit that files of other tools do not have. Call it when the shaft is known.
void read_kit_rest(yaml::Section& section, model::RotorKit& kit);
std::vector<keys::Key> kit_rest_keys();
keys::Key name_key(std::string meaning = "name in messages, tables and figures");

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

std::vector<keys::Key> rotor_kit_keys();  ///< The keys that read_rotor_kit reads.

void print_rotor_kit(yaml::Printer& printer, const model::RotorKit& kit,
                     MatrixPrint matrices = MatrixPrint::inside);

model::Range places(const model::RotorKit& kit);  ///< Allowed positions along the shaft: between its ends.

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

/// Puts the columns of a file in place of every `rotor.supports.N.table: {file: NAME}` (table_file.hpp).
/// Columns are named as the keys are, or "Speed [rpm]", "Kxx [lbf/in]" with the usual units.
void resolve_tables(yaml::Node& root, yaml::Diagnostics& diagnostics);

/// Reads a table of supports from a map of columns, each a list. The speeds, speed_hz, speed_rpm or
/// speed_rad_per_s, must all rise or all fall. The other columns are kxx, kxy, kyx, kyy in N/m, cxx to cyy in
/// N s/m, mxx and myy in kg. A name may end in its unit: kxx_n_per_m, kxx_n_per_mm, kxx_n_per_um,
/// kxx_lbf_per_in, cxx_ns_per_m, cxx_ns_per_mm, cxx_lbf_s_per_in, mxx_kg. kxx and kyy are required, other
/// columns are 0 if left out. Empty after a problem.
std::optional<model::SupportTable> read_support_table(const yaml::Value& value);
keys::Form support_table_form();
void print_support_table(yaml::Printer& printer, const model::SupportTable& table);

}  // namespace rubsweep::config::machine
