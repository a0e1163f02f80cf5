#include "rubsweep/sweep/footprint.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "sweep/one_side_study.hpp"

namespace rubsweep::sweep {
namespace {

using Cells = std::vector<std::size_t>;

TEST(Footprint, GrowsWithThreadsWindowsAndCells) {
  Study study = one_side_study({50, 60}, {0.1});
  const Footprint one = footprint(study, {1});
  const std::size_t window = 12 * 32;
  EXPECT_EQ(footprint(study, {3}).memory_bytes - one.memory_bytes, 2 * (1'000'000 + 192 * window));
  EXPECT_EQ(footprint(study, {3}).disk_bytes, one.disk_bytes);
  study.response.window_revolutions *= 100;
  EXPECT_EQ(footprint(study, {1}).memory_bytes - one.memory_bytes, 192 * 99 * window);
  study.grid.unbalance.resize(1000);
  EXPECT_EQ(footprint(study, {1}).disk_bytes, 1000 * one.disk_bytes);
}

TEST(Footprint, OfRanksIsThatOfEach) {
  const Study study = one_side_study({50, 60}, {0.1});
  EXPECT_EQ(footprint(study, {2, 1}).memory_bytes - footprint(study, {2}).memory_bytes, 30'000'000u);
  EXPECT_EQ(footprint(study, {2, 9}).memory_bytes, footprint(study, {2, 1}).memory_bytes);
}

TEST(TakePilotCells, SpreadsThemEvenlyAndLeavesTheOthers) {
  Cells cells(10);
  std::iota(cells.begin(), cells.end(), std::size_t{100});
  EXPECT_EQ(take_pilot_cells(cells, 2), (Cells{102, 107}));
  EXPECT_EQ(cells, (Cells{100, 101, 103, 104, 105, 106, 108, 109}));
}

TEST(TakePilotCells, TakesNoMoreThanThereAre) {
  Cells cells{4, 5, 6};
  EXPECT_EQ(take_pilot_cells(cells, 7), (Cells{4, 5, 6}));
  EXPECT_EQ(cells, Cells{});
  EXPECT_EQ(take_pilot_cells(cells, 7), Cells{});
  cells = {1, 2};
  EXPECT_EQ(take_pilot_cells(cells, 0), Cells{});
  EXPECT_EQ(cells, (Cells{1, 2}));
}

}  // namespace
}  // namespace rubsweep::sweep
