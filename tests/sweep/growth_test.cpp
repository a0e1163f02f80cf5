#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "batch/temporary_directory.hpp"
#include "rubsweep/batch/journal.hpp"
#include "rubsweep/batch/line_log.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "rubsweep/sweep/run_cells.hpp"
#include "sweep/one_side_study.hpp"

namespace rubsweep::sweep {
namespace {

/// What this process holds in memory.
std::size_t resident_bytes() {
  std::size_t total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Cells of every kind, over and over: rest, rub with and without a period, initial contact.
Study study_of_everything() {
  Study study = one_side_study({50, 60, 66, 75, 90, 105}, {0, 0.2, 0.4, 0.55, 0.8, 1.2});
  study.response.window_revolutions = 12;
  study.response.max_revolutions = 200;
  study.response.max_order = 6;
  return study;
}

TEST(Growth, OfASweepThatRunsForEverThereIsNone) {
  constexpr std::size_t half = 2000, allowed_bytes = 64 * 1024;
  const Study study = study_of_everything();
  std::vector<std::size_t> cells(2 * half);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = i % cell_count(study.grid);
  const TemporaryDirectory directory;
  batch::Journal journal(directory.path() / "map.journal", {"study", "program", cells.size(), "text\n"});
  batch::LineLog partial(directory.path() / "map.partial.csv");
  std::map<response::MotionClass, std::size_t> classes;
  std::size_t finished = 0, halfway_bytes = 0;
  run_cells(
      study, cells, 2,
      [&](std::size_t cell, const Row& row) {
        const std::string line = report::map_line(row);
        journal.append(cell, line);
        partial.append(line);
        ++classes[row.motion_class];
        if (++finished == half) halfway_bytes = resident_bytes();
      },
      false);
  EXPECT_EQ(finished, 2 * half);
  EXPECT_GE(classes.size(), 4u);
  EXPECT_GT(classes[response::MotionClass::subharmonic], half / 4);
  EXPECT_LE(resident_bytes(), halfway_bytes + allowed_bytes) << halfway_bytes << " bytes halfway";
}

}  // namespace
}  // namespace rubsweep::sweep
