#include "rubsweep/analysis/page/orbits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"

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

/// Over clearances; one of them is not allowed.
sweep::Study clearance_study(std::vector<double> clearance_m) {
  sweep::Study study = sweep::one_side_study({50, 60}, {0.2});
  study.grid.axes = {{{"stops.0.clearance_m"}, {1}, std::move(clearance_m)}};
  study.with_keys = [machine = study.machine](std::span<const sweep::KeyValue> keys) {
    if (!(keys.front().value > 0)) throw ConfigError("stops.0.clearance_m: allowed: a number > 0");
    sweep::Study own;
    own.machine = machine;
    own.machine.stops.front().clearance_m = keys.front().value;
    return own;
  };
  return study;
}

TEST(OrbitsWalls, AreThoseOfTheMachineWithoutAxesOverKeys) {
  const sweep::Study study = sweep::one_side_study({50, 60, 70}, {0.2, 0.6});
  const Walls walls = walls_of(study);
  ASSERT_EQ(walls.lists.size(), 1u);
  EXPECT_EQ(walls.list_of_keys, std::vector<std::size_t>{0});
  ASSERT_EQ(walls.lists.front().size(), study.machine.stops.size());
  EXPECT_DOUBLE_EQ(walls.lists.front().front().clearance_m, study.machine.stops.front().clearance_m);
  EXPECT_FALSE(walls.lists.front().front().around);
}

TEST(OrbitsWalls, AreToldOnceForEachPlaceThatKeysPutThem) {
  const Walls walls = walls_of(clearance_study({1e-4, 2e-4, 1e-4}));
  EXPECT_EQ(walls.list_of_keys, (std::vector<std::size_t>{0, 1, 0}));
  ASSERT_EQ(walls.lists.size(), 2u);
  EXPECT_DOUBLE_EQ(walls.lists[0].front().clearance_m, 1e-4);
  EXPECT_DOUBLE_EQ(walls.lists[1].front().clearance_m, 2e-4);
}

TEST(OrbitsWalls, AreNoneWhereKeysAreNotAllowed) {
  const Walls walls = walls_of(clearance_study({-1, 1e-4}));
  ASSERT_EQ(walls.list_of_keys, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(walls.lists[0].empty());
  EXPECT_FALSE(walls.lists[1].empty());
}

}  // namespace
}  // namespace rubsweep::page
