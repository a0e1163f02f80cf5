#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubreport/map_table.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Status of a cell that a refined map did not compute.
inline constexpr std::string_view not_computed = "not computed";

/// A refined map with a row for each cell of its grid.
struct PaintedTable {
  MapTable map;
  std::vector<std::size_t> computed;  ///< cells that are in the map itself, ascending
  std::vector<int> labels;            ///< labels of the computed cells; sweep::unknown_label for all others
};

/// Adds a row for every cell of `grid` that `map`, which was read with this grid, does not have. Such a row
/// has its own place, the class and order of its block (see sweep/refinement.hpp), and the status
/// not_computed. Orbit, whirl and comb are those of the nearest computed cell before it with the same label.
/// Throws IoError where a cell that the refinement needs has no row.
PaintedTable painted_table(const MapTable& map, const sweep::Grid& grid);

/// Findings of a map for people, one sentence each: extent and share of lasting rub, its most frequent
/// motion, the largest force and displacement, chaos, proven results, and uncertain cells.
std::vector<std::string> findings(const MapTable& map, const sweep::Grid& grid);

}  // namespace rubsweep::page
