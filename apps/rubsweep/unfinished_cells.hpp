#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// Cells that are still missing before the parts of a map can be merged.
struct UnfinishedCells {
  std::vector<std::size_t> cells;  ///< ascending; empty: the map can be written
  std::size_t shard_count = 0;     ///< number of shards in the finest division that was started; 0: none
  std::set<std::size_t> shards;    ///< numbers, from 1, of the shards with these cells
};

/// Cells of a complete map that have no result. For a refined map, the next cells that its finished cells
/// require; later ones are not known yet. `grid` belongs to the directory. Throws IoError.
UnfinishedCells unfinished_cells(const map::MapDirectory& directory, const sweep::Grid& grid);

}  // namespace rubsweep::apps
