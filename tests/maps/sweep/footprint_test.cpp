#include "rubsweep/maps/sweep/footprint.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/scene/kit_machine.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::sweep {
namespace {

using Cells = std::vector<std::size_t>;

Footprint footprint(const Study& study, const Workers& workers) {
  return sweep::footprint(study, scene::prepare_machine(study.machine), workers);
}

TEST(Footprint, GrowsWithThreadsWindowsAndCells) {
  Study study = one_side_study({50, 60}, {0.1});
  const Footprint one = footprint(study, {1});
  const std::size_t window = 12 * 32;
  const std::size_t flows = integrate::exact::modes::most_bytes_of_modes(4, 1);
  EXPECT_EQ(footprint(study, {3}).memory_bytes - one.memory_bytes, 2 * (1'000'000 + 192 * window + flows));
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

std::size_t bytes_beyond(const Study& study, const Study& less) {
  return footprint(study, {1}).memory_bytes - footprint(less, {1}).memory_bytes -
         24 * cell_count(study.grid) + 24 * cell_count(less.grid);
}

/// Gyroscopic forces make a kit a different machine at each speed; axes over its keys do, too.
TEST(Footprint, CountsTheFlowsOfEveryMachineUpToWhatIsKept) {
  Study one = one_side_study({50}, {0.1, 0.2}), more = one;
  more.grid.speed_hz = {50, 60, 70};
  EXPECT_EQ(bytes_beyond(more, one), 0u);
  more.grid.axes = {{{"stops.0.stiffness_n_per_m"}, {1}, {1e6, 2e6}}};
  EXPECT_EQ(bytes_beyond(more, one), integrate::exact::modes::most_bytes_of_modes(4, 1));
  more.grid.axes = {{{"kick.force_n"}, {1}, {10, 20}}};
  EXPECT_EQ(bytes_beyond(more, one), 0u);

  one.machine = more.machine = scene::light_shaft_machine();
  const Eigen::Index coordinates = scene::prepare_machine(one.machine).assembly.system.coordinates();
  EXPECT_EQ(bytes_beyond(more, one), 2 * integrate::exact::modes::most_bytes_of_modes(coordinates, 1));
  more.grid.speed_hz.resize(10'000);
  const std::size_t most = integrate::exact::modes::most_bytes_of_a_mode_cache;
  EXPECT_EQ(bytes_beyond(more, one), most - integrate::exact::modes::most_bytes_of_modes(coordinates, 1));
  more = one;
  more.threshold.emplace().axis.keys = {"stops.0.friction.coefficient"};
  EXPECT_EQ(bytes_beyond(more, one), most - integrate::exact::modes::most_bytes_of_modes(coordinates, 1));
  more.threshold->axis.keys = {"kick.force_n"};
  EXPECT_EQ(bytes_beyond(more, one), 0u);
}

TEST(Footprint, IsNeverMoreThanIsKnownWithoutTheMachine) {
  Study study = one_side_study({50, 60}, {0.1});
  EXPECT_LT(footprint(study, {2}).memory_bytes, most_memory_bytes(study, {2}));
  study.threshold.emplace().axis.keys = {"stops.0.friction.coefficient"};
  EXPECT_EQ(footprint(study, {2}).memory_bytes, most_memory_bytes(study, {2}));
}

TEST(FootprintTakePilotCells, SpreadsThemEvenlyAndLeavesTheOthers) {
  Cells cells(10);
  std::iota(cells.begin(), cells.end(), std::size_t{100});
  EXPECT_EQ(take_pilot_cells(cells, 2), (Cells{102, 107}));
  EXPECT_EQ(cells, (Cells{100, 101, 103, 104, 105, 106, 108, 109}));
}

TEST(FootprintTakePilotCells, TakesNoMoreThanThereAre) {
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
