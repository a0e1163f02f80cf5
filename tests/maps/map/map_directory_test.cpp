#include "rubsweep/maps/map/map_directory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"
#include "rubsweep/maps/map/map_files.hpp"

namespace rubsweep::map {
namespace {

namespace fs = std::filesystem;
using Cells = std::vector<std::size_t>;

/// Names of the remaining files, except locks.
std::vector<std::string> files_in(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() != ".lock") names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

TEST(MapDirectory, GoesOnWhereAnEarlierCallEnded) {
  const SmallMap map;
  map.begin().journal().append(2, SmallMap::line(2));
  const MapDirectory directory = map.begin();
  EXPECT_EQ(directory.cells(), 4u);
  EXPECT_EQ(directory.finished(), 1u);
  EXPECT_EQ(directory.missing(), (Cells{0, 1, 3}));
  EXPECT_NE(batch::read_whole_file(directory.partial()).find(SmallMap::line(2)), std::string::npos);
}

TEST(MapDirectory, PutsTheCellsOfAllJournalsInOrderAndRemovesThem) {
  const SmallMap map;
  for (const std::size_t index : Cells{1, 0}) {
    const MapDirectory shard = map.begin(Share{index, 2});
    EXPECT_EQ(shard.cells(), 2u);
    for (const std::size_t cell : shard.missing()) shard.journal().append(cell, SmallMap::line(cell));
  }
  const MapDirectory whole = map.begin();
  EXPECT_TRUE(whole.missing().empty());
  EXPECT_EQ(whole.shards_begun(), 2u);
  whole.write_map();
  EXPECT_EQ(files_in(map.path), (std::vector<std::string>{"config.yaml", "map.csv"}));
  const std::string table = batch::read_whole_file(whole.map());
  std::size_t last = 0;
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const std::size_t at = table.find(SmallMap::line(cell) + "\n");
    ASSERT_NE(at, std::string::npos) << cell;
    EXPECT_GT(at, last);
    last = at;
  }
}

TEST(MapDirectory, WritesNoMapThatLacksACell) {
  const SmallMap map;
  const MapDirectory directory = map.begin();
  directory.journal().append(0, SmallMap::line(0));
  EXPECT_NE(message_of<IoError>([&] { directory.write_map(); }).find("3 of 4 cells are not finished"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(directory.map()));
  EXPECT_EQ(map.path / "map.journal", map.path / files_in(map.path)[1]);
}

TEST(MapDirectory, FindsAWholeMapAndNothingLeftToDo) {
  const SmallMap map;
  map.finish();
  const MapDirectory directory = map.begin();
  ASSERT_TRUE(directory.finished_map());
  EXPECT_EQ(directory.finished_map()->cells, 4u);
  EXPECT_TRUE(directory.missing().empty());
}

TEST(MapDirectory, LeavesWhatBelongsToAnotherConfigurationAsItIs) {
  const SmallMap map;
  map.begin().journal().append(1, SmallMap::line(1));
  const std::string before = batch::read_whole_file(map.path / "map.journal"),
                    configuration = batch::read_whole_file(map.path / "config.yaml");
  const std::string message = message_of<ConfigError>([&] { map.begin({}, false, {"rotor.mass_kg=0.9"}); });
  EXPECT_NE(message.find("rotor.mass_kg"), std::string::npos) << message;
  EXPECT_EQ(batch::read_whole_file(map.path / "map.journal"), before);
  EXPECT_EQ(batch::read_whole_file(map.path / "config.yaml"), configuration);
}

TEST(MapDirectory, ForgetsAllThatWasMadeOfAMapWhenFresh) {
  const SmallMap map;
  map.finish();
  for (const std::string_view name : derived_files()) std::ofstream(map.path / name) << "old";
  std::ofstream(map.path / "notes.txt") << "of a person";
  EXPECT_EQ(map.begin({}, true).missing(), (Cells{0, 1, 2, 3}));
  EXPECT_EQ(files_in(map.path), (std::vector<std::string>{"config.yaml", "map.partial.csv", "notes.txt"}));
}

TEST(MapDirectory, AFreshShardLeavesTheOthersTheirCells) {
  const SmallMap map;
  map.begin(Share{0, 2}).journal().append(0, SmallMap::line(0));
  map.begin(Share{1, 2}).journal().append(1, SmallMap::line(1));
  EXPECT_EQ(map.begin(Share{1, 2}, true).missing(), (Cells{1, 3}));
  EXPECT_EQ(map.begin(Share{0, 2}).missing(), (Cells{2}));
}

TEST(MapDirectory, KeepsASecondProcessAway) {
  const SmallMap map;
  MapDirectory directory = map.begin();
  EXPECT_THROW(map.begin(), LockedError);
  directory.leave();
  EXPECT_NO_THROW(map.begin());
}

TEST(MapDirectory, RefusesALinkInThePlaceOfAJournal) {
  const SmallMap map;
  map.begin();
  fs::create_symlink(map.temporary.path() / "somebody", map.path / "map.journal");
  EXPECT_THROW(map.begin({}, true), IoError);
}

TEST(MapDirectory, ACellWhoseRecordIsDamagedIsMissingAgain) {
  const SmallMap map;
  {
    const MapDirectory directory = map.begin();
    for (const std::size_t cell : Cells{0, 1, 2}) directory.journal().append(cell, SmallMap::line(cell));
  }
  const fs::path journal = map.path / "map.journal";
  std::string text = batch::read_whole_file(journal);
  const std::size_t at = text.find(SmallMap::line(1));
  ASSERT_NE(at, std::string::npos);
  text[at] = 'x';
  std::ofstream(journal) << text;
  EXPECT_EQ(map.begin().missing(), (Cells{1, 3}));
}

TEST(MapDirectory, ALastRecordThatWasTornCostsItsCellAlone) {
  const SmallMap map;
  {
    const MapDirectory directory = map.begin();
    for (const std::size_t cell : Cells{0, 1}) directory.journal().append(cell, SmallMap::line(cell));
  }
  const fs::path journal = map.path / "map.journal";
  fs::resize_file(journal, fs::file_size(journal) - 7);
  {
    const MapDirectory directory = map.begin();
    EXPECT_EQ(directory.missing(), (Cells{1, 2, 3}));
    for (const std::size_t cell : directory.missing()) directory.journal().append(cell, SmallMap::line(cell));
  }
  map.begin().write_map();
  EXPECT_NE(batch::read_whole_file(map.path / "map.csv").find(SmallMap::line(1)), std::string::npos);
}

TEST(MapDirectory, TakesTheCellsOfAnotherDivisionAndOfRanksAlong) {
  const SmallMap map;
  map.begin(Share{2, 3}).journal().append(2, SmallMap::line(2));
  config::RunConfig config = SmallMap::config();
  config.output_directory = map.path;
  rank_journal(config, 1).append(1, SmallMap::line(1));
  EXPECT_EQ(map.begin(Share{0, 2}).missing(), (Cells{0}));
  EXPECT_EQ(map.begin().missing(), (Cells{0, 3}));
  EXPECT_EQ(map.begin().shards_begun(), 3u);
}

TEST(MapDirectory, VisitsFinishedCellsInTheirOrder) {
  const SmallMap map;
  const MapDirectory directory = map.begin();
  for (const std::size_t cell : Cells{3, 0}) directory.journal().append(cell, SmallMap::line(cell));
  Cells visited;
  directory.for_each_finished([&](std::size_t cell, const std::string& line) {
    visited.push_back(cell);
    EXPECT_EQ(line, SmallMap::line(cell));
  });
  EXPECT_EQ(visited, (Cells{0, 3}));
}

TEST(MapDirectory, KnowsWhichOtherShardIsAtWork) {
  const SmallMap map;
  const MapDirectory first = map.begin(Share{0, 2});
  EXPECT_FALSE(first.is_at_work_on({1, 3}));
  const MapDirectory second = map.begin(Share{1, 2});
  EXPECT_TRUE(first.is_at_work_on({0, 1}));
  EXPECT_FALSE(first.is_at_work_on({0, 2}));
}

}  // namespace
}  // namespace rubsweep::map
