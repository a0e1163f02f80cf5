#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::report {

/// Treatment of a column by rubsweep-compare, which compares two maps.
enum class Comparison {
  ignored,
  key,     ///< identifies the cell
  label,   ///< part of the name of the motion: must be equal in every cell
  text,    ///< must be equal where the motion repeats
  number,  ///< must agree to the tolerance where the motion repeats; lengths relative to the cell's
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

/// Columns of map.csv in the order of the file. A new column goes to the end, so that no other moves.
std::span<const MapColumn> map_columns();

/// Place of the column called `name`, from 0. Throws SolverError where there is none.
std::size_t place_of_column(std::string_view name);

/// Descriptions of all columns and classes of motion, for --help; lines end with '\n'.
std::string describe_map_columns();

/// Names of the columns with this comparison, joined by ", ".
std::string columns_compared(Comparison comparison);

/// Column names of map.csv as one line without its end: first those of every map, then those that only this
/// kind of study has.
std::string map_header(const sweep::Study& study = {});

/// One row of the map of `study`, without its line end. Numbers read back to the same double; an entry that
/// does not apply is empty.
std::string map_line(const sweep::Row& row, const sweep::Study& study = {});

/// Comment lines of a map, between the comment lines of every table and the column names: a line on the units
/// and, for axes over keys, a line with the columns of their keys. Each has its line end.
std::string map_comments(const sweep::Study& study = {});

}  // namespace rubsweep::report
