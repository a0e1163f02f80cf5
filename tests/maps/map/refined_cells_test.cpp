#include "rubsweep/maps/map/refined_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "maps/map/small_map.hpp"

namespace rubsweep::map {
namespace {

/// Adds the wanted cells with the order that `order_of` gives them, until no more are wanted; returns their
/// number.
template <class OrderOf>
std::size_t cells_wanted(const sweep::Grid& grid, const OrderOf& order_of) {
  RefinedCells known(grid);
  std::size_t cells = 0;
  for (auto wanted = known.wanted(); !wanted.empty(); wanted = known.wanted()) {
    cells += wanted.size();
    for (const std::size_t cell : wanted) known.add(cell, SmallMap::line(0, order_of(cell)));
  }
  return cells;
}

TEST(RefinedCells, WantMoreWhereLabelsDiffer) {
  const config::RunConfig config = SmallMap::config(SmallMap::refined());
  const sweep::Grid& grid = config.study.grid;
  const std::size_t all = sweep::cell_count(grid);
  const std::size_t alike = cells_wanted(grid, [](std::size_t) { return 2; }),
                    differing = cells_wanted(grid, [](std::size_t cell) { return cell % 5 < 2 ? 2 : 3; });
  EXPECT_GT(alike, 0u);
  EXPECT_LT(alike, differing);
  EXPECT_LE(differing, all);
}

TEST(RefinedCells, ReadWhatAnyJournalOfTheDirectoryHolds) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config(SmallMap::refined());
  const MapDirectory directory = map.begin({}, false, SmallMap::refined());
  RefinedCells known(config.study.grid);
  const std::vector<std::size_t> wanted = known.wanted();
  ASSERT_GT(wanted.size(), 1u);
  directory.journal().append(wanted.front(), SmallMap::line(0));
  known.read(directory);
  EXPECT_EQ(known.wanted(), std::vector<std::size_t>(wanted.begin() + 1, wanted.end()));
}

}  // namespace
}  // namespace rubsweep::map
