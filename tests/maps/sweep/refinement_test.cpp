#include "rubsweep/maps/sweep/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::sweep {
namespace {

Grid grid_of(std::size_t speeds, std::size_t unbalances, Refinement refinement) {
  Grid grid;
  grid.speed_hz.resize(speeds);
  std::iota(grid.speed_hz.begin(), grid.speed_hz.end(), 1.0);
  grid.unbalance.resize(unbalances);
  std::iota(grid.unbalance.begin(), grid.unbalance.end(), 0.0);
  grid.refinement = refinement;
  return grid;
}

using Truth = std::function<int(double, double)>;

int truth_of(const Grid& grid, const Truth& truth, std::size_t cell) {
  const std::size_t speeds = grid.speed_hz.size();
  const std::size_t speed = cell % speeds, unbalance = cell / speeds;
  return truth(static_cast<double>(speed), static_cast<double>(unbalance));
}

/// Labels of a complete refined map whose cells are computed round by round.
std::vector<int> refined(const Grid& grid, const Truth& truth) {
  std::vector<int> labels(cell_count(grid), unknown_label);
  for (auto wanted = wanted_cells(grid, labels); !wanted.empty(); wanted = wanted_cells(grid, labels)) {
    for (const std::size_t cell : wanted) {
      EXPECT_EQ(labels[cell], unknown_label);
      labels[cell] = truth_of(grid, truth, cell);
    }
  }
  return labels;
}

int disc(double x, double y) { return std::hypot(x - 61.3, y - 40.7) < 25.2 ? 1 : 0; }

TEST(Refinement, FindsASmoothBoundaryExactlyFromFewCells) {
  const Grid grid = grid_of(130, 90, {4, 0});
  const std::vector<int> labels = refined(grid, disc), painted = painted_labels(grid, labels);
  for (std::size_t cell = 0; cell < painted.size(); ++cell)
    ASSERT_EQ(painted[cell], truth_of(grid, disc, cell)) << cell;
  const auto computed = labels.size() - static_cast<std::size_t>(std::ranges::count(labels, unknown_label));
  EXPECT_LT(computed, labels.size() / 10);
  const auto exponent = boundary_exponent(grid, labels);
  ASSERT_TRUE(exponent);
  EXPECT_NEAR(*exponent, 1, 0.15);
}

TEST(Refinement, ShowsForEachCellOneThatWasComputedAndHasItsPaintedLabel) {
  const Grid grid = grid_of(40, 30, {3, 1});
  const std::vector<int> labels = refined(grid, disc), painted = painted_labels(grid, labels);
  const std::vector<std::size_t> shown = shown_cells(grid, labels);
  ASSERT_EQ(shown.size(), labels.size());
  for (std::size_t cell = 0; cell < shown.size(); ++cell) {
    EXPECT_EQ(labels[shown[cell]], painted[cell]) << cell;
    if (labels[cell] != unknown_label) {
      EXPECT_EQ(shown[cell], cell);
    }
  }
}

/// The wanted cells do not depend on an interrupt, the number of threads or the order of the cells.
TEST(Refinement, WantsTheSameCellsInWhateverOrder) {
  const Grid grid = grid_of(70, 53, {3, 2});
  const std::vector<int> at_once = refined(grid, disc);
  std::mt19937 random(7);
  std::vector<int> labels(cell_count(grid), unknown_label);
  for (auto wanted = wanted_cells(grid, labels); !wanted.empty(); wanted = wanted_cells(grid, labels)) {
    const std::size_t cell = wanted[random() % wanted.size()];
    labels[cell] = truth_of(grid, disc, cell);
  }
  EXPECT_EQ(labels, at_once);
}

TEST(Refinement, MissesNoIslandAsLargeAsItsBound) {
  for (const int probes : {0, 1, 3}) {
    const Grid grid = grid_of(65, 65, {4, probes});
    const auto side = static_cast<double>(island_bound(grid));
    EXPECT_LE(side, 16);
    for (double x = 0; x + side <= 65; x += 3) {
      for (double y = 0; y + side <= 65; y += 3) {
        const auto island = [=](double i, double j) {
          return i >= x && i < x + side && j >= y && j < y + side ? 1 : 0;
        };
        const auto labels = refined(grid, island);
        ASSERT_GT(std::ranges::count(labels, 1), 0) << probes << ' ' << x << ' ' << y;
      }
    }
  }
  EXPECT_EQ(island_bound(grid_of(65, 65, {4, 0})), 16u);
}

TEST(Refinement, AlongOneAxisMissesNoIslandAsLongAsItsBound) {
  for (const bool speeds : {true, false}) {
    for (const int probes : {0, 1, 3}) {
      const Grid grid = speeds ? grid_of(65, 1, {4, probes}) : grid_of(1, 65, {4, probes});
      const auto length = static_cast<double>(island_bound(grid));
      EXPECT_EQ(length == 16, probes == 0);
      int missed = 0;  // number of islands shorter by one cell
      for (double x = 0; x + length <= 65; ++x) {
        const auto along = [=](double i, double j, double cells) {
          return std::max(i, j) >= x && std::max(i, j) < x + cells ? 1 : 0;
        };
        const auto island = [=](double i, double j) { return along(i, j, length); };
        const auto shorter = [=](double i, double j) { return along(i, j, length - 1); };
        ASSERT_GT(std::ranges::count(refined(grid, island), 1), 0) << probes << ' ' << x;
        missed += std::ranges::count(refined(grid, shorter), 1) == 0;
      }
      EXPECT_GT(missed, 0);
    }
  }
}

TEST(Refinement, ComputesNoMoreThanLatticeAndProbesWhereAllIsEqual) {
  const Grid grid = grid_of(33, 17, {3, 1});
  const auto labels = refined(grid, [](double, double) { return 5; });
  EXPECT_EQ(std::ranges::count(labels, 5), 5 * 3 + 4 * 2);
  EXPECT_FALSE(boundary_exponent(grid, labels));
  EXPECT_EQ(painted_labels(grid, labels), std::vector<int>(cell_count(grid), 5));
}

TEST(Refinement, LevelsCountTheSplitsBeforeACell) {
  const Grid grid = grid_of(17, 9, {3, 0});
  EXPECT_EQ(refinement_level(grid, 0), 0);
  EXPECT_EQ(refinement_level(grid, 8), 0);
  EXPECT_EQ(refinement_level(grid, 4), 1);
  EXPECT_EQ(refinement_level(grid, 17UL * 2), 2);
  EXPECT_EQ(refinement_level(grid, 17UL * 8 + 16), 0);
  EXPECT_EQ(refinement_level(grid, 17UL * 3 + 8), 3);
}

TEST(Refinement, ProbesAreMetBeforeAnySplit) {
  const Grid grid = grid_of(33, 17, {3, 2});
  const std::vector<int> unknown(cell_count(grid), unknown_label);
  const auto first = wanted_cells(grid, unknown);
  EXPECT_EQ(first.size(), 5u * 3 + 4 * 2 * 2);
  for (std::size_t cell = 0; cell < cell_count(grid); ++cell)
    EXPECT_EQ(refinement_level(grid, cell) == 0, std::ranges::binary_search(first, cell)) << cell;
}

TEST(Refinement, TakesALineAndMapsOfAThirdAxis) {
  const Grid line = grid_of(100, 1, {3, 0});
  const auto step = [](double x, double) { return x < 37 ? 0 : 1; };
  const auto labels = refined(line, step);
  EXPECT_EQ(painted_labels(line, labels)[36], 0);
  EXPECT_EQ(painted_labels(line, labels)[37], 1);
  EXPECT_LT(100 - std::ranges::count(labels, unknown_label), 25);

  Grid maps = grid_of(17, 9, {3, 0});
  maps.axes = {{{"kick.force_n"}, {1}, {1, 2, 3}}};
  std::vector<int> none(cell_count(maps), unknown_label);
  EXPECT_EQ(wanted_cells(maps, none).size(), 3u * 3 * 2);
}

}  // namespace
}  // namespace rubsweep::sweep
