#include "rubsweep/analysis/page/walls.hpp"

#include <gtest/gtest.h>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::page {
namespace {

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

TEST(Walls, AreThoseOfTheMachineWithoutAxesOverKeys) {
  const sweep::Study study = sweep::one_side_study({50, 60, 70}, {0.2, 0.6});
  const Walls walls = walls_of(study);
  ASSERT_EQ(walls.lists.size(), 1u);
  EXPECT_EQ(walls.list_of_keys, std::vector<std::size_t>{0});
  ASSERT_EQ(walls.lists.front().size(), study.machine.stops.size());
  EXPECT_DOUBLE_EQ(walls.lists.front().front().clearance_m, study.machine.stops.front().clearance_m);
  EXPECT_FALSE(walls.lists.front().front().around);
}

TEST(Walls, AreToldOnceForEachPlaceThatKeysPutThem) {
  const Walls walls = walls_of(clearance_study({1e-4, 2e-4, 1e-4}));
  EXPECT_EQ(walls.list_of_keys, (std::vector<std::size_t>{0, 1, 0}));
  ASSERT_EQ(walls.lists.size(), 2u);
  EXPECT_DOUBLE_EQ(walls.lists[0].front().clearance_m, 1e-4);
  EXPECT_DOUBLE_EQ(walls.lists[1].front().clearance_m, 2e-4);
}

TEST(Walls, AreNoneWhereKeysAreNotAllowed) {
  const Walls walls = walls_of(clearance_study({-1, 1e-4}));
  ASSERT_EQ(walls.list_of_keys, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(walls.lists[0].empty());
  EXPECT_FALSE(walls.lists[1].empty());
}

}  // namespace
}  // namespace rubsweep::page
