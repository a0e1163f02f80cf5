#include "rubsweep/analysis/page/orbits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rubsweep::page {
namespace {

TEST(Orbits, ASmallMapKeepsAllItsCells) {
  const ThinnedGrid grid = thinned_grid(3, 2, 6);
  EXPECT_TRUE(grid.whole());
  EXPECT_EQ(grid.cells(), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
}

TEST(Orbits, ALargeOneKeepsSomeAllOverIt) {
  const ThinnedGrid grid = thinned_grid(400, 250, 4000);
  EXPECT_FALSE(grid.whole());
  const auto cells = grid.cells();
  EXPECT_LE(cells.size(), 4000u);
  EXPECT_GT(cells.size(), 2500u);
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end()));
  EXPECT_LT(cells.back(), 100000u);
  // No cell is farther from a kept one than half a stride.
  EXPECT_LT(cells.front() % 400, grid.speed_stride);
  EXPECT_GE(cells.back() % 400 + grid.speed_stride, 400u);
}

TEST(Orbits, ALineKeepsItsOtherAxis) {
  const ThinnedGrid grid = thinned_grid(1000, 1, 10);
  EXPECT_EQ(grid.unbalance_stride, 1u);
  EXPECT_LE(grid.cells().size(), 10u);
  EXPECT_GE(grid.cells().size(), 9u);
  EXPECT_EQ(thinned_grid(1, 1000, 1).cells().size(), 1u);
  EXPECT_EQ(thinned_grid(100, 1000, 1).cells().size(), 1u);
}

}  // namespace
}  // namespace rubsweep::page
