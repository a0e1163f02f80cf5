#include "rubsweep/maps/map/cell_log.hpp"

#include <gtest/gtest.h>

#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"

namespace rubsweep::map {
namespace {

TEST(CellLog, ACellIsInTheJournalAndInThePartialMapAtOnce) {
  const SmallMap map;
  MapDirectory directory = map.begin();
  CellLog log(directory, batch::ProgressMode::never);
  log.add(3, SmallMap::line(3));
  EXPECT_EQ(log.finished(), 1u);
  EXPECT_TRUE(batch::read_whole_file(directory.partial()).ends_with('\n' + SmallMap::line(3) + '\n'));
  directory.leave();
  EXPECT_EQ(map.begin().missing(), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(CellLog, ACellOfAnotherProcessIsShownAndStaysInItsOwnJournal) {
  const SmallMap map;
  MapDirectory directory = map.begin();
  {
    CellLog log(directory, batch::ProgressMode::never);
    log.add_of_other_process(3, SmallMap::line(3));
    EXPECT_EQ(log.finished(), 1u);
    EXPECT_TRUE(batch::read_whole_file(directory.partial()).ends_with('\n' + SmallMap::line(3) + '\n'));
  }
  directory.leave();
  EXPECT_EQ(map.begin().missing().size(), 4u);
}

TEST(CellLog, TheMessageAfterASignalCountsWhatEarlierRunsFinished) {
  const SmallMap map;
  map.begin().journal().append(1, SmallMap::line(1));
  const MapDirectory directory = map.begin();
  EXPECT_EQ(interrupted_map("rubtest", directory, 2),
            "rubtest: interrupted; 3 of 4 cells are finished, the same command computes the others\n");
}

}  // namespace
}  // namespace rubsweep::map
