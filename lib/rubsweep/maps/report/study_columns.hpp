#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::report {

/// A column of map.csv that only a study of one kind has, behind those of every map and of the axes over
/// keys.
struct StudyColumn {
  std::string_view name;
  std::string_view description;                      ///< text for --help
  std::string (*text)(const sweep::Row&) = nullptr;  ///< text of the cell; empty: does not apply
};

/// Columns of torsion, of iterated secants, of robustness as a probability, of a refined map, of a study of
/// thresholds, and of basins.
std::vector<StudyColumn> all_study_columns();

/// All that a map of this study has.
std::vector<StudyColumn> study_columns(const sweep::Study& study);

/// Every one with its description, for --help; lines end with '\n'.
std::string describe_study_columns();

/// Columns behind all others of a map, which say its speeds and unbalances in the units of the person who
/// wrote the configuration: `speed_rpm`, `unbalance_g_mm`, `balance_grade_mm_per_s`. They are for reading:
/// the SI columns are what a cell was computed for. Journals hold no such columns, so that studies that
/// differ by units alone can go on with each other's cells.

/// Their names, each with a comma before it; empty where everything is written in SI units.
std::string unit_header(const sweep::Grid& grid);

/// Their cells for a row, or for a line of map.csv, in the same way.
std::string unit_cells(const sweep::Row& row, const sweep::Grid& grid);
std::string unit_cells(std::string_view map_line, const sweep::Grid& grid);

/// A header of map.csv without such columns, whatever units they are for.
std::string_view without_unit_columns(std::string_view header);

/// All columns that there may be, for --help; lines end with '\n'.
std::string describe_unit_columns();

}  // namespace rubsweep::report
