#include "rubsweep/maps/map/finished_map.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/study_digest.hpp"
#include "rubsweep/maps/map/journal_header.hpp"

namespace rubsweep::map {
namespace {

FinishedMap found(const SmallMap& map, const sweep::Study& study) {
  return read_finished_map("test", map.path / "map.csv", study, 100);
}

TEST(FinishedMap, IsReadWithItsCellsAndDigest) {
  const SmallMap map;
  map.finish();
  const sweep::Study study = SmallMap::config().study;
  const FinishedMap there = found(map, study);
  EXPECT_EQ(there.digest, config::study_digest(study));
  EXPECT_EQ(there.cells, 4u);
  EXPECT_TRUE(there.known_columns);
  EXPECT_TRUE(there.missing.empty());
  EXPECT_NO_THROW(refuse_map_of_another(there, map.path / "map.csv", journal_header(study)));
}

TEST(FinishedMap, IsRefusedWithEveryKeyThatDiffers) {
  const SmallMap map;
  map.finish();
  const sweep::Study other = SmallMap::config({"rotor.mass_kg=0.9", "rotor.damping_ratio=0.03"}).study;
  const FinishedMap there = found(map, other);
  const std::string message = message_of<ConfigError>(
      [&] { refuse_map_of_another(there, map.path / "map.csv", journal_header(other)); });
  for (const char* part :
       {"is a finished map of another configuration", "rotor.mass_kg", "rotor.damping_ratio"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(FinishedMap, IsRefusedWhereItIsNotAsItWasWritten) {
  const SmallMap map;
  map.finish();
  std::string table = batch::read_whole_file(map.path / "map.csv");
  table[table.size() - 3] = 'x';
  std::ofstream(map.path / "map.csv") << table;
  EXPECT_THROW(found(map, SmallMap::config().study), batch::DamagedTable);
}

TEST(FinishedMap, OfNoProgramSaysNoDigest) {
  const SmallMap map;
  std::filesystem::create_directories(map.path);
  std::ofstream(map.path / "map.csv") << "speed_hz,class\n60,synchronous\n";
  const sweep::Study study = SmallMap::config().study;
  const FinishedMap there = found(map, study);
  EXPECT_TRUE(there.digest.empty());
  const std::string message = message_of<ConfigError>(
      [&] { refuse_map_of_another(there, map.path / "map.csv", journal_header(study)); });
  EXPECT_NE(message.find("is no map of this program"), std::string::npos) << message;
}

TEST(FinishedMap, KnowsItsCellsByTheirValuesInAnyOrder) {
  const SmallMap map;
  map.finish();
  const sweep::Study study = SmallMap::config().study;
  map.give_rows({SmallMap::line(2), SmallMap::line(3), SmallMap::line(0), SmallMap::line(1)});
  EXPECT_EQ(found(map, study).cells, 4u);
  EXPECT_TRUE(found(map, study).missing.empty());
  map.give_rows({SmallMap::line(2), SmallMap::line(3), SmallMap::line(0)});
  const FinishedMap there = found(map, study);
  EXPECT_EQ(there.missing, "speed_hz 70, whirl_ratio 0.25");
  const std::string message = message_of<ConfigError>(
      [&] { refuse_map_of_another(there, map.path / "map.csv", journal_header(study)); });
  EXPECT_NE(message.find("holds 3 cells of this configuration, which has 4"), std::string::npos) << message;
}

TEST(FinishedMap, WithACellTwiceOrOfNoGridIsRefusedWithItsLine) {
  const SmallMap map;
  map.finish();
  const sweep::Study study = SmallMap::config().study;
  map.give_rows({SmallMap::line(0), SmallMap::line(1), SmallMap::line(1)});
  EXPECT_NE(message_of<IoError>([&] { found(map, study); }).find("is there twice"), std::string::npos);
  std::string foreign = SmallMap::line(0);
  ASSERT_TRUE(foreign.starts_with("60,"));
  map.give_rows({foreign.replace(0, 2, "61")});
  EXPECT_NE(message_of<IoError>([&] { found(map, study); }).find("is no cell of its configuration"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::map
