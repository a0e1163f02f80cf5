#include "rubsweep/unfinished_cells.hpp"

#include <gtest/gtest.h>

#include "maps/map/small_map.hpp"

namespace rubsweep::apps {
namespace {

using map::MapDirectory, map::Share, map::SmallMap;

using Cells = std::vector<std::size_t>;
using Shards = std::set<std::size_t>;

TEST(UnfinishedCells, AreAllWhereNothingWasBegun) {
  const SmallMap map;
  const UnfinishedCells unfinished = unfinished_cells(map.begin(), SmallMap::config().study.grid);
  EXPECT_EQ(unfinished.cells, (Cells{0, 1, 2, 3}));
  EXPECT_EQ(unfinished.shard_count, 0u);
  EXPECT_TRUE(unfinished.shards.empty());
}

TEST(UnfinishedCells, NameTheShardsThatHaveThem) {
  const SmallMap map;
  {
    const MapDirectory second = map.begin(Share{1, 3});
    for (const std::size_t cell : second.missing()) second.journal().append(cell, SmallMap::line(cell));
  }
  const UnfinishedCells unfinished = unfinished_cells(map.begin(), SmallMap::config().study.grid);
  EXPECT_EQ(unfinished.cells, (Cells{0, 2, 3}));
  EXPECT_EQ(unfinished.shard_count, 3u);
  EXPECT_EQ(unfinished.shards, (Shards{1, 3}));
}

TEST(UnfinishedCells, AreNoneOnceAllShardsAreThere) {
  const SmallMap map;
  for (const std::size_t index : Cells{0, 1}) {
    const MapDirectory shard = map.begin(Share{index, 2});
    for (const std::size_t cell : shard.missing()) shard.journal().append(cell, SmallMap::line(cell));
  }
  EXPECT_TRUE(unfinished_cells(map.begin(), SmallMap::config().study.grid).cells.empty());
}

TEST(UnfinishedCells, OfARefinedMapAreThoseThatItWantsNext) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config(SmallMap::refined());
  const sweep::Grid& grid = config.study.grid;
  const UnfinishedCells unfinished = unfinished_cells(map.begin({}, false, SmallMap::refined()), grid);
  EXPECT_EQ(unfinished.cells,
            sweep::wanted_cells(grid, std::vector<int>(sweep::cell_count(grid), sweep::unknown_label)));
  EXPECT_LT(unfinished.cells.size(), sweep::cell_count(grid));
}

}  // namespace
}  // namespace rubsweep::apps
