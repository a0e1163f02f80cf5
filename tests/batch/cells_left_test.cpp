#include "rubsweep/batch/cells_left.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rubsweep/batch/progress.hpp"

namespace rubsweep::batch {
namespace {

std::vector<std::size_t> all_of(std::size_t cells) {
  std::vector<std::size_t> numbers(cells);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

TEST(CellsLeft, KnowsNothingBeforeACellWasMeasured) {
  CellsLeft cells(4, 4, all_of(16));
  EXPECT_EQ(cells.left(), 16u);
  EXPECT_FALSE(cells.one_by_one_s().has_value());
  EXPECT_EQ(cells.finished_s(), 0);
  cells.finish(3, {});
  EXPECT_EQ(cells.left(), 15u);
  EXPECT_FALSE(cells.one_by_one_s().has_value());
}

TEST(CellsLeft, AreAsTheOthersWhereAllAreAlike) {
  CellsLeft cells(5, 3, all_of(15));
  cells.finish(0, 2);
  EXPECT_NEAR(*cells.one_by_one_s(), 28, 1e-12);
  cells.finish(14, 2);
  EXPECT_NEAR(*cells.one_by_one_s(), 26, 1e-12);
  EXPECT_EQ(cells.finished_s(), 4);
  cells.finish(1, {});
  EXPECT_NEAR(*cells.one_by_one_s(), 24, 1e-12);
  EXPECT_EQ(cells.finished_s(), 6);  // the third as the two
}

TEST(CellsLeft, AreAsTheirNeighbours) {
  // Quick on the left, slow on the right, where all are left.
  CellsLeft cells(8, 4, all_of(32));
  for (const std::size_t row : {0u, 1u, 2u, 3u})
    for (const std::size_t column : {0u, 1u, 2u, 3u}) cells.finish(8 * row + column, 1);
  cells.finish(8 + 5, 100);
  cells.finish(8 * 2 + 6, 100);
  EXPECT_GT(*cells.one_by_one_s(), 14 * 60);
  EXPECT_LT(*cells.one_by_one_s(), 14 * 100);  // where the mean of all promises 14 * 12
}

TEST(CellsLeft, LargeMapsAreTiled) {
  CellsLeft cells(1000, 1000, all_of(1000000));
  for (std::size_t cell = 0; cell < 1000000; cell += 97) cells.finish(cell, cell < 500000 ? 1 : 3);
  const double expected = (500000 * 1. + 500000 * 3.) * (1 - 1 / 97.);
  EXPECT_NEAR(*cells.one_by_one_s() / expected, 1, 1e-3);
}

/// Seconds of a cell of a made-up map of 40 speeds and 25 unbalances: quiet below, rubbing above, and in a
/// tongue on top of it long chaotic ones.
double seconds_of(std::size_t cell) {
  const auto speed = static_cast<double>(cell % 40);
  const std::size_t unbalance = cell / 40;
  const double tongue = std::abs(speed - 25);
  if (unbalance >= 18 && tongue < 6) return 1.5;
  return unbalance >= 12 ? 0.08 + 0.002 * speed : 0.001;
}

/// A sweep on one thread as rubsweep does it: 32 cells spread over the map, then the others row by row, so
/// that the slow ones come last.
std::vector<std::size_t> order_of_sweep() {
  std::vector<std::size_t> order, others;
  for (std::size_t cell = 0; cell < 1000; ++cell) (cell * 32 % 1000 < 32 ? order : others).push_back(cell);
  order.insert(order.end(), others.begin(), others.end());
  return order;
}

TEST(CellsLeftTime, IsHonestWhereTheSlowCellsComeLast) {
  const std::vector<std::size_t> order = order_of_sweep();
  const double total_s = std::accumulate(order.begin(), order.end(), 0.,
                                         [](double sum, std::size_t cell) { return sum + seconds_of(cell); });
  CellsLeft cells(40, 25, order);
  double elapsed_s = 0, worst = 1, worst_by_rate = 1, worst_early = 1, last_off_s = 0;
  for (std::size_t done = 1; done < order.size(); ++done) {
    const std::size_t cell = order[done - 1];
    elapsed_s += seconds_of(cell);
    cells.finish(cell, seconds_of(cell));
    const double true_s = total_s - elapsed_s, said_s = *time_left_s(cells, elapsed_s, 0);
    const double off = std::max(said_s / true_s, true_s / said_s);
    const double by_rate_s = static_cast<double>(order.size() - done) * elapsed_s / static_cast<double>(done);
    if (true_s < total_s / 50) {
      last_off_s = std::max(last_off_s, std::abs(said_s - true_s));
    } else if (elapsed_s > total_s / 2) {
      worst = std::max(worst, off);
      worst_by_rate = std::max({worst_by_rate, by_rate_s / true_s, true_s / by_rate_s});
    } else if (done >= 32) {
      worst_early = std::max(worst_early, off);
    }
  }
  EXPECT_LT(worst_early, 1.5);
  EXPECT_LT(worst, 1.2);
  EXPECT_LT(last_off_s, 1);
  EXPECT_GT(worst_by_rate, 3);
}

TEST(CellsLeftTime, CountsTheThreadsThatWereBusy) {
  CellsLeft cells(10, 10, all_of(100));
  EXPECT_FALSE(time_left_s(cells, 1, 0).has_value());
  for (std::size_t cell = 0; cell < 40; ++cell) cells.finish(cell, 1);
  EXPECT_NEAR(*time_left_s(cells, 10, 0), 15, 1e-9);  // four threads
  EXPECT_NEAR(*time_left_s(cells, 80, 0), 60, 1e-9);  // never less than one
  for (std::size_t cell = 40; cell < 98; ++cell) cells.finish(cell, 1);
  EXPECT_NEAR(*time_left_s(cells, 24.5, 0), 1, 1e-9);  // two cells for four threads
}

TEST(CellsLeftTime, AWaitPromisesAsLongAWait) {
  CellsLeft cells(10, 1, all_of(10));
  for (std::size_t cell = 0; cell < 9; ++cell) cells.finish(cell, 1);
  EXPECT_NEAR(*time_left_s(cells, 9, 0), 1, 1e-9);
  EXPECT_NEAR(*time_left_s(cells, 59, 50), 50, 1e-9);
  cells.finish(9, 50);
  EXPECT_EQ(time_left_s(cells, 59, 0), 0);
}

}  // namespace
}  // namespace rubsweep::batch
