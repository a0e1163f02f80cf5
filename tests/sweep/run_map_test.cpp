#include "rubsweep/sweep/run_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "batch/message_of.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "sweep/one_side_study.hpp"

namespace rubsweep::sweep {
namespace {

using Lines = std::vector<std::string>;

/// Rows as map.csv would hold them; "" for cells that did not run.
Lines lines_of(const std::vector<std::optional<Row>>& rows) {
  Lines lines;
  for (const auto& row : rows) lines.push_back(row ? report::map_line(*row) : "");
  return lines;
}

/// Nine cells of several classes: rest, contact, initial contact.
Study mixed_study() { return one_side_study({50, 75, 105}, {0, 0.4, 1.2}); }

TEST(RunMap, AnyNumberOfThreadsGivesTheRowsOfTheCellsInTheirOrder) {
  const Study study = mixed_study();
  Lines expected;
  for (std::size_t cell = 0; cell < cell_count(study.grid); ++cell) {
    response::Workspace workspace;
    expected.push_back(report::map_line(evaluate_cell(study, cell, workspace)));
  }
  for (const int threads : {1, 2, 5, 0}) {
    EXPECT_EQ(lines_of(run_map(
                  study, threads, [](const Row&) {}, false)),
              expected)
        << threads << " threads";
  }
}

TEST(RunMap, EveryRowIsSeenOnce) {
  const Study study = mixed_study();
  Lines seen;
  const auto rows = run_map(
      study, 3, [&](const Row& row) { seen.push_back(report::map_line(row)); }, false);
  Lines expected = lines_of(rows);
  std::sort(expected.begin(), expected.end());
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(seen, expected);
}

TEST(RunMap, StopLeavesTheRestEmpty) {
  const Study study = mixed_study();
  const Lines all = lines_of(run_map(
      study, 1, [](const Row&) {}, false));
  std::atomic<bool> stop = false;
  int seen = 0;
  const Lines some = lines_of(run_map(
      study, 1, [&](const Row&) { stop = ++seen == 2; }, stop));
  ASSERT_EQ(some.size(), all.size());
  EXPECT_EQ(std::count(some.begin(), some.end(), ""), static_cast<std::ptrdiff_t>(all.size()) - 2);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!some[i].empty()) {
      EXPECT_EQ(some[i], all[i]);
    }
  }
}

TEST(RunMap, StoppedBeforeItBeganRunsNothing) {
  const auto rows = run_map(
      mixed_study(), 2, [](const Row&) { ADD_FAILURE() << "a row"; }, true);
  EXPECT_EQ(lines_of(rows), Lines(9));
}

TEST(RunMap, AMachineThatIsNotValidIsTheUsersToMend) {
  Study study = one_side_study({50, 60}, {0.1});
  study.machine.stops[0].clearance_m = -1;
  EXPECT_EQ(message_of<ConfigError>([&] {
              run_map(
                  study, 1, [](const Row&) {}, false);
            }),
            "stops.0.clearance_m: -1 is out of range, allowed: a number > 0");
}

}  // namespace
}  // namespace rubsweep::sweep
