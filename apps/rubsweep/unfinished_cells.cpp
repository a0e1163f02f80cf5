#include "unfinished_cells.hpp"

#include "rubsweep/maps/map/refined_cells.hpp"

namespace rubsweep::apps {

UnfinishedCells unfinished_cells(const map::MapDirectory& directory, const sweep::Grid& grid) {
  UnfinishedCells unfinished{directory.missing(), directory.shards_begun(), {}};
  if (grid.refinement) {
    map::RefinedCells known(grid);
    known.read(directory);
    unfinished.cells = known.wanted();
  }
  if (unfinished.shard_count == 0) return unfinished;
  for (const std::size_t cell : unfinished.cells)
    unfinished.shards.insert(directory.share_in(cell, unfinished.shard_count) + 1);
  return unfinished;
}

}  // namespace rubsweep::apps
