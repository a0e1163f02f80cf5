#include "rubsweep/maps/batch/finished_cells.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/maps/batch/journal.hpp"

namespace rubsweep::batch {
namespace {

using CellNumbers = std::vector<std::size_t>;

const JournalHeader of_six_cells{"study", "program", 6, ""};

TEST(FinishedCells, WithoutJournalsEverythingIsMissing) {
  const FinishedCells cells(6);
  EXPECT_EQ(cells.count(), 0u);
  EXPECT_EQ(cells.missing(), (CellNumbers{0, 1, 2, 3, 4, 5}));
}

TEST(FinishedCells, AreThoseOfAllJournals) {
  const TemporaryDirectory directory;
  const auto one = directory.path() / "one.journal", two = directory.path() / "two.journal";
  const std::string long_text(5000, 'x');
  {
    Journal journal(one, of_six_cells);
    journal.append(4, "four");
    journal.append(1, long_text);
  }
  {
    Journal journal(two, of_six_cells);
    journal.append(1, "again");
    journal.append(0, "");
  }
  FinishedCells cells(6);
  EXPECT_EQ(cells.add(one), 0u);
  EXPECT_EQ(cells.add(two), 0u);
  EXPECT_EQ(cells.count(), 3u);
  EXPECT_EQ(cells.missing(), (CellNumbers{2, 3, 5}));
  EXPECT_EQ(cells.text(0), "");
  EXPECT_EQ(cells.text(1), long_text) << "the first record counts";
  EXPECT_EQ(cells.text(4), "four");
}

}  // namespace
}  // namespace rubsweep::batch
