#include "rubsweep/maps/map/earlier_results.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::map {
namespace {

class EarlierResultsJournalHeaderOfAStudy : public testing::Test {
 protected:
  const SmallMap map_{};
  const std::filesystem::path path_ = map_.temporary.path() / "map.journal";
  const sweep::Study study_ = SmallMap::config().study;

  void write(const batch::JournalHeader& header) const { batch::Journal(path_, header).append(0, "text"); }

  /// Overwrites this number of bytes at the beginning of the file.
  void damage(std::size_t bytes) const {
    std::string text = batch::read_whole_file(path_);
    std::fill_n(text.begin(), bytes, '\1');
    std::ofstream(path_) << text;
  }

  std::string refusal(const batch::JournalHeader& here) const {
    return message_of<ConfigError>([&] { refuse_journal_of_another(path_, here); });
  }
};

TEST_F(EarlierResultsJournalHeaderOfAStudy, OfTheSameStudyAndBuildIsTaken) {
  write(journal_header(study_));
  EXPECT_NO_THROW(refuse_journal_of_another(path_, journal_header(study_)));
}

TEST_F(EarlierResultsJournalHeaderOfAStudy, OfAnotherStudyIsRefusedWithTheKeysThatDiffer) {
  write(journal_header(study_));
  const std::string message = refusal(journal_header(SmallMap::config({"rotor.mass_kg=0.9"}).study));
  for (const char* part :
       {"holds finished cells of another configuration", "rotor.mass_kg", "0.8", "0.9", "--fresh"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST_F(EarlierResultsJournalHeaderOfAStudy, OfAnotherBuildIsRefusedWithBothDigests) {
  write(journal_header(study_, "another"));
  const std::string message = refusal(journal_header(study_));
  EXPECT_NE(message.find("of another build of the program (digest another, this one has "), std::string::npos)
      << message;
}

TEST_F(EarlierResultsJournalHeaderOfAStudy, WithAFirstLineThatIsDamagedIsTakenByTheOthers) {
  write(journal_header(study_));
  damage(4);
  EXPECT_NO_THROW(refuse_journal_of_another(path_, journal_header(study_)));
}

TEST_F(EarlierResultsJournalHeaderOfAStudy, WithoutAnyHeaderIsLeftAsItIs) {
  write(journal_header(study_));
  damage(batch::read_whole_file(path_).size());
  const std::string before = batch::read_whole_file(path_);
  const std::string message =
      message_of<batch::DamagedJournal>([&] { refuse_journal_of_another(path_, journal_header(study_)); });
  EXPECT_NE(message.find("It is left as it is"), std::string::npos) << message;
  EXPECT_EQ(batch::read_whole_file(path_), before);
}

FinishedMap found(const SmallMap& map, const sweep::Study& study) {
  return read_finished_map("test", map.path / "map.csv", study, 100);
}

TEST(EarlierResultsFinishedMap, IsReadWithItsCellsAndDigest) {
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

TEST(EarlierResultsFinishedMap, IsRefusedWithEveryKeyThatDiffers) {
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

TEST(EarlierResultsFinishedMap, IsRefusedWhereItIsNotAsItWasWritten) {
  const SmallMap map;
  map.finish();
  std::string table = batch::read_whole_file(map.path / "map.csv");
  table[table.size() - 3] = 'x';
  std::ofstream(map.path / "map.csv") << table;
  EXPECT_THROW(found(map, SmallMap::config().study), batch::DamagedTable);
}

TEST(EarlierResultsFinishedMap, OfNoProgramSaysNoDigest) {
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

TEST(EarlierResultsFinishedMap, KnowsItsCellsByTheirValuesInAnyOrder) {
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

TEST(EarlierResultsFinishedMap, WithACellTwiceOrOfNoGridIsRefusedWithItsLine) {
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
