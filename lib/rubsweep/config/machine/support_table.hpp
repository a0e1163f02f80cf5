#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/model/support_table.hpp"

namespace rubsweep::config::machine {

/// Puts the columns of a file in place of every `rotor.supports.N.table: {file: NAME}`: text with a line of
/// names and lines of numbers, parted by commas; blank lines and those that begin with # do not count. NAME
/// is relative to the file that it stands in. What cannot be had is a problem of the key, what is wrong in
/// the file one of its line.
void resolve_tables(yaml::Node& root, yaml::Diagnostics& diagnostics);

/// Columns by name, each a list: speed_hz or speed_rpm, then kxx, kxy, kyx, kyy in N/m, cxx to cyy in N s/m,
/// mxx and myy in kg. Each name may say its unit: kxx_n_per_m, kxx_n_per_mm, kxx_n_per_um, cxx_ns_per_m,
/// cxx_ns_per_mm, mxx_kg. kxx and kyy must be given, what is left out is 0. Empty after a problem.
std::optional<model::SupportTable> read_support_table(const yaml::Value& value);
void print_support_table(yaml::Printer& printer, const model::SupportTable& table);

}  // namespace rubsweep::config::machine
