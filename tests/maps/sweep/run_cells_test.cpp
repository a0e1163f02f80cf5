#include "rubsweep/maps/sweep/run_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

/// Lines of map.csv by cell.
using Lines = std::map<std::size_t, std::string>;

/// A study of nine cells with several classes: rest, contact, initial contact.
Study mixed_study() { return one_side_study({50, 75, 105}, {0, 0.4, 1.2}); }

std::vector<std::size_t> all_cells(const Study& study) {
  std::vector<std::size_t> cells(cell_count(study.grid));
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return cells;
}

/// Lines from evaluating each cell alone.
Lines expected_lines(const Study& study, const std::vector<std::size_t>& cells) {
  Lines lines;
  for (const std::size_t cell : cells) {
    response::motion::Workspace workspace;
    lines[cell] = report::map_line(evaluate_cell(study, cell, workspace));
  }
  return lines;
}

/// Lines that run_cells returns; a cell returned twice is a failure.
Lines run(const Study& study, const std::vector<std::size_t>& cells, int threads) {
  Lines lines;
  const std::size_t finished = run_cells(
      study, cells, threads,
      [&](std::size_t cell, const Row& row) {
        EXPECT_TRUE(lines.emplace(cell, report::map_line(row)).second) << cell;
      },
      false);
  EXPECT_EQ(finished, lines.size());
  return lines;
}

TEST(RunCells, AnyNumberOfThreadsGivesTheRowOfEachCellOnce) {
  const Study study = mixed_study();
  const auto cells = all_cells(study);
  const Lines expected = expected_lines(study, cells);
  for (const int threads : {1, 2, 5, 0}) EXPECT_EQ(run(study, cells, threads), expected) << threads;
}

TEST(RunCells, OrderAndCompanyOfACellDoNotChangeItsRow) {
  const Study study = mixed_study();
  auto cells = all_cells(study);
  const Lines expected = expected_lines(study, cells);
  std::reverse(cells.begin(), cells.end());
  EXPECT_EQ(run(study, cells, 1), expected);
  const std::vector<std::size_t> some{7, 1, 4};
  EXPECT_EQ(run(study, some, 2), expected_lines(study, some));
  EXPECT_EQ(run(study, {}, 2), Lines());
}

/// One prepared machine computes a part of the cells at a time, as in a rank of MPI.
TEST(RunCells, AMachinePreparedBeforeGivesTheSameRows) {
  const Study study = mixed_study();
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  const auto cells = all_cells(study);
  Lines lines;
  for (std::size_t first = 0; first < cells.size(); first += 3) {
    run_cells(
        study, prepared, std::span(cells).subspan(first, 3), 2,
        [&](std::size_t cell, const Row& row) { lines[cell] = report::map_line(row); }, false);
  }
  EXPECT_EQ(lines, expected_lines(study, cells));
}

TEST(RunCells, AfterStopNoCellStarts) {
  const Study study = mixed_study();
  const auto cells = all_cells(study);
  std::atomic<bool> stop = false;
  std::vector<std::size_t> seen;
  const std::size_t finished = run_cells(
      study, cells, 1,
      [&](std::size_t cell, const Row&) {
        seen.push_back(cell);
        stop = seen.size() == 2;
      },
      stop);
  EXPECT_EQ(finished, 2u);
  EXPECT_EQ(seen.size(), 2u);
}

TEST(RunCells, StoppedBeforeItBeganRunsNothing) {
  const Study study = mixed_study();
  EXPECT_EQ(run_cells(
                study, all_cells(study), 2,
                [](std::size_t cell, const Row&) { ADD_FAILURE() << "a row of cell " << cell; }, true),
            0u);
}

TEST(RunCells, AMachineThatIsNotValidIsTheUsersToMend) {
  Study study = one_side_study({50, 60}, {0.1});
  study.machine.stops[0].clearance_m = -1;
  EXPECT_EQ(message_of<ConfigError>([&] {
              run(study, {0, 1}, 1);
            }),
            "stops.0.clearance_m: -1 is out of range, allowed: a number > 0");
}

}  // namespace
}  // namespace rubsweep::sweep
