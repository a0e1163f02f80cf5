#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::report {

/// How rubsweep-compare takes a column of two maps.
enum class Comparison {
  ignored,
  key,     ///< says which cell it is
  label,   ///< part of what the motion is called: must be equal in every cell
  text,    ///< must be equal where the motion repeats
  number,  ///< must agree to the tolerance where the motion repeats; what has unit m relative to the cell's
           ///< peak
};

/// Definition of one column of map.csv.
struct MapColumn {
  std::string_view name;  ///< ends with the unit where there is one
  std::string_view unit;  ///< SI, such as "m"; empty: a pure number or a word
  Comparison comparison = Comparison::ignored;
  std::string_view description;  ///< text for --help
  /// Text of the cell. Numbers read back to the same double; an entry that does not apply is empty.
  std::string (*text)(const sweep::Row&) = nullptr;
};

/// The columns in the order of the file. A new one stands at the end, where it moves no other.
std::span<const MapColumn> map_columns();

/// Place of the column called `name`, from 0. Throws SolverError where there is none.
std::size_t place_of_column(std::string_view name);

/// Every column and every class with its description, for --help; lines end with '\n'.
std::string describe_map_columns();

/// Names of the columns with this comparison, joined by ", ".
std::string columns_compared(Comparison comparison);

/// The column names of map.csv, as one line without its end: those of every map, then those that this study
/// has beside them.
std::string map_header(const sweep::Study& study = {});

/// One row of the map of `study`, without its end. Numbers read back to the same double; an entry that does
/// not apply is empty.
std::string map_line(const sweep::Row& row, const sweep::Study& study = {});

/// Comment lines above the header of a map, after the head that every table has: a `#` line on the units and,
/// for axes over keys, one that names the columns of their keys; each with its line end.
std::string map_comments(const sweep::Study& study = {});

}  // namespace rubsweep::report
