#pragma once

#include <string>

#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::report {

/// The column names of map.csv, as one line without its end: those of every map, then those that this study
/// has beside them.
std::string map_header(const sweep::Study& study = {});

/// One row of the map of `study`, without its end. Numbers read back to the same double; an entry that does
/// not apply is empty.
std::string map_line(const sweep::Row& row, const sweep::Study& study = {});

/// Comment lines above the header of a map, after the head that every table has: a `#` line on the units and,
/// for axes over keys, one that names the columns of their keys; each with its end.
std::string map_comments(const sweep::Study& study = {});

}  // namespace rubsweep::report
