#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::machine {

/// Columns of a file of bearing characteristics as ANSYS imports it, by the keys of a table of supports: up
/// to three lines of titles, then how many speeds there are and two flags, and for each speed a line with its
/// number and speed, one with K11, K12, K21, K22 and one with C11, C12, C21, C22. The first flag is 1 for
/// lbf/in and lbf s/in, 0 for N/m and N s/m; the second is 1 for rpm, 0 for rad/s; one that is left out is 1.
/// Nothing for another text. Throws table::Fault for such a file that is not whole. `file`: see
/// yaml::SourcePosition.
std::optional<yaml::Node> read_ansys_bearing(std::string_view text, int file);

}  // namespace rubsweep::config::machine
