#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::report {

/// Column of map.csv that only one kind of study has. It follows the columns of every map and those of the
/// axes over keys.
struct StudyColumn {
  std::string_view name;
  std::string_view description;                      ///< text for --help
  std::string (*text)(const sweep::Row&) = nullptr;  ///< text of the cell; empty: does not apply
};

/// Columns for torsion, iterated secants, robustness as a probability, refined maps, thresholds, and basins.
std::vector<StudyColumn> all_study_columns();

/// Columns of all_study_columns that a map of this study has.
std::vector<StudyColumn> study_columns(const sweep::Study& study);

/// Descriptions of all columns that only some studies have, for --help; lines end with '\n'.
std::string describe_study_columns();

/// Last columns of a map, which repeat its speeds and unbalances in the units of the configuration:
/// `speed_rpm`, `unbalance_g_mm`, `balance_grade_mm_per_s`. They are only for reading: cells are computed
/// from the numbers in the SI columns. Journals do not contain these columns, so that studies that differ
/// only by units can use each other's cells.

/// Names of the unit columns, each with a comma before it; empty where all axes are written in SI units.
std::string unit_header(const sweep::Grid& grid);

/// Cells of the unit columns for a row, or for a line of map.csv, each with a comma before it.
std::string unit_cells(const sweep::Row& row, const sweep::Grid& grid);
std::string unit_cells(std::string_view map_line, const sweep::Grid& grid);

/// Header of map.csv without any unit columns that it has.
std::string_view without_unit_columns(std::string_view header);

/// Descriptions of all unit columns, for --help; lines end with '\n'.
std::string describe_unit_columns();

}  // namespace rubsweep::report
