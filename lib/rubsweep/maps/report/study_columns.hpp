#pragma once

#include <span>
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
  std::string_view description;                      ///< for --help
  std::string (*text)(const sweep::Row&) = nullptr;  ///< text of the cell; empty: does not apply
};

/// Columns of torsion, of iterated secants, of a study of thresholds, of basins, of a refined map, and of
/// robustness as a probability.
std::span<const StudyColumn> torsion_columns();
std::span<const StudyColumn> hertz_columns();
std::span<const StudyColumn> threshold_columns();
std::span<const StudyColumn> basin_columns();
std::span<const StudyColumn> refinement_columns();
std::span<const StudyColumn> robustness_columns();

/// All that a map of this study has.
std::vector<StudyColumn> study_columns(const sweep::Study& study);

/// Every one with its description, for --help; lines end with '\n'.
std::string describe_study_columns();

}  // namespace rubsweep::report
