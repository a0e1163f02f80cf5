#include "rubsweep/map_status.hpp"

#include <gtest/gtest.h>

#include "maps/batch/message_of.hpp"
#include "maps/map/small_map.hpp"

namespace rubsweep::apps {
namespace {

using map::Share;
using map::SmallMap;

TEST(MapStatus, SaysWhereNoMapWasBegunAndWhereItIsWhole) {
  const SmallMap map;
  EXPECT_NE(message_of<IoError>([&] { map_status(map.path); }).find("is not a directory"), std::string::npos);
  std::filesystem::create_directory(map.path);
  EXPECT_EQ(map_status(map.path), map.path.string() + ": no map was begun here\n");
  map.finish();
  EXPECT_EQ(map_status(map.path), map.path.string() + ": the map is there, nothing is left to do\n");
}

TEST(MapStatus, CountsTheCellsOfEachShardAndNamesThoseThatWereNotBegun) {
  const SmallMap map;
  map.begin(Share{0, 2}).journal().append(2, SmallMap::line(2));
  EXPECT_EQ(map_status(map.path), map.path.string() +
                                      ": 1 of 4 cells are finished (25 %), nobody is at work\n"
                                      "  map.shard-1-of-2                1  nobody is at work\n"
                                      "  map.shard-2-of-2                -  not begun\n");
}

TEST(MapStatus, CountsACellThatTwoJournalsHoldOnce) {
  const SmallMap map;
  map.begin(Share{0, 2}).journal().append(2, SmallMap::line(2));
  map.begin().journal().append(2, SmallMap::line(2));
  EXPECT_NE(map_status(map.path).find("1 of 4 cells are finished"), std::string::npos)
      << map_status(map.path);
}

TEST(MapStatus, NamesWhoIsAtWork) {
  const SmallMap map;
  const map::MapDirectory directory = map.begin();
  const batch::Journal journal = directory.journal();
  const std::string text = map_status(map.path);
  EXPECT_NE(text.find("0 of 4 cells are finished (0 %), 0 cells/s\n"), std::string::npos) << text;
  EXPECT_NE(text.find("at work: test"), std::string::npos) << text;
}

}  // namespace
}  // namespace rubsweep::apps
