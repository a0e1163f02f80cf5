#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// Cells that keep the parts of a map from being put together.
struct UnfinishedCells {
  std::vector<std::size_t> cells;  ///< ascending; none: the map can be written
  std::size_t shard_count = 0;  ///< shards of the division that was begun, the finest of several; 0: none was
  std::set<std::size_t> shards;  ///< numbers of the shards that have these cells, from 1
};

/// Cells without a result of a whole map; those that the finished cells of a refined map want next, since
/// which others it needs is known only from these. `grid` is that of the directory. Throws IoError.
UnfinishedCells unfinished_cells(const map::MapDirectory& directory, const sweep::Grid& grid);

}  // namespace rubsweep::apps
