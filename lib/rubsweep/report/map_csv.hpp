#pragma once

#include <string>

#include "rubsweep/sweep/row.hpp"

namespace rubsweep::report {

/// The column names of map.csv, as one line without its end.
std::string map_header();

/// One row of map.csv, without its end. Numbers read back to the same double; what does not apply is empty.
std::string map_line(const sweep::Row& row);

/// What stands above the header: `#` lines with version, digest of the physics and units, one per line with
/// its end.
std::string map_comments(const std::string& version, const std::string& digest);

}  // namespace rubsweep::report
