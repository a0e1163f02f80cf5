#pragma once

#include <optional>

#include "rubsweep/core/model/support_table.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

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
