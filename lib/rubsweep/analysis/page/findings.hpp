#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Word in the column `status` of a cell that a refined map did not compute.
inline constexpr std::string_view not_computed = "not computed";

/// A refined map with a row for each cell of its grid.
struct PaintedTable {
  MapTable map;
  std::vector<std::size_t> computed;  ///< the cells that the map held, ascending
  std::vector<int> labels;            ///< labels of these cells, sweep::unknown_label of all others
};

/// Gives every cell of `grid` a row: those of `map` as they are; any other has its place, the class and order
/// of its block (see sweep/refinement.hpp), orbit, whirl and comb of the computed cell of that label nearest
/// before it, the status not_computed, and nothing else. `map` was read with the grid. Throws IoError where a
/// cell that the refinement asks for has no row.
PaintedTable painted_table(const MapTable& map, const sweep::Grid& grid);

/// Findings of a map, one sentence each, for people: size, share and extent of lasting rub, its most frequent
/// motion, the largest force and displacement, chaos, what is proven, and which cells say little.
std::vector<std::string> findings(const MapTable& map, const sweep::Grid& grid);

}  // namespace rubsweep::page
