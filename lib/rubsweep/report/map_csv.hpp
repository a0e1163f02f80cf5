#pragma once

#include <string>

#include "rubsweep/sweep/row.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::report {

/// The column names of map.csv, as one line without its end: those of every map, then those that this study
/// has beside them.
std::string map_header(const sweep::Study& study = {});

/// One row of the map of `study`, without its end. Numbers read back to the same double; what does not apply
/// is empty.
std::string map_line(const sweep::Row& row, const sweep::Study& study = {});

/// What stands above the header: `#` lines with version, digest of the physics and units, one per line with
/// its end. A study with axes over keys names the columns of their keys in one more line.
std::string map_comments(const std::string& version, const std::string& digest,
                         const sweep::Study& study = {});

}  // namespace rubsweep::report
