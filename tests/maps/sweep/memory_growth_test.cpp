#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "maps/batch/temporary_directory.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"

namespace rubsweep::sweep {
namespace {

/// Resident memory of this process, bytes.
std::size_t resident_bytes() {
  std::size_t total = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// A study with cells of every kind: rest, periodic and aperiodic rubs, initial contact.
Study study_of_everything() {
  Study study = one_side_study({50, 60, 66, 75, 90, 105}, {0, 0.2, 0.4, 0.55, 0.8, 1.2});
  study.response.window_revolutions = 12;
  study.response.max_revolutions = 200;
  study.response.max_order = 6;
  return study;
}

TEST(MemoryGrowth, OfASweepThatRunsForEverThereIsNone) {
  // The allocator may take a page or two at any time; a leak would grow in every stretch.
  constexpr std::size_t warm = 2000, stretch = 2000, stretches = 2, allowed_bytes = 64 * 1024;
  const Study study = study_of_everything();
  std::vector<std::size_t> cells(warm + stretches * stretch);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = i % cell_count(study.grid);
  const TemporaryDirectory directory;
  batch::Journal journal(directory.path() / "map.journal", {"study", "program", cells.size(), "text\n"});
  batch::LineLog partial(directory.path() / "map.partial.csv");
  std::map<response::motion::MotionClass, std::size_t> classes;
  std::size_t finished = 0;
  std::vector<std::size_t> bytes;
  run_cells(
      study, cells, 2,
      [&](std::size_t cell, const Row& row) {
        const std::string line = report::map_line(row);
        journal.append(cell, line);
        partial.append(line);
        ++classes[row.motion_class];
        if (++finished >= warm && (finished - warm) % stretch == 0) bytes.push_back(resident_bytes());
      },
      false);
  EXPECT_EQ(finished, cells.size());
  EXPECT_GE(classes.size(), 4u);
  EXPECT_GT(classes[response::motion::MotionClass::subharmonic], cells.size() / 8);
  ASSERT_EQ(bytes.size(), stretches + 1);
  bool grows = true;
  for (std::size_t i = 1; i < bytes.size(); ++i) grows = grows && bytes[i] > bytes[i - 1] + allowed_bytes;
  EXPECT_FALSE(grows) << bytes.front() << " bytes, then " << bytes.back();
}

}  // namespace
}  // namespace rubsweep::sweep
