#include "rubsweep/maps/map/journal_header.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::map {
namespace {

class JournalHeaderOfAStudy : public testing::Test {
 protected:
  const SmallMap map_{};
  const std::filesystem::path path_ = map_.temporary.path() / "map.journal";
  const sweep::Study study_ = SmallMap::config().study;

  void write(const batch::JournalHeader& header) const { batch::Journal(path_, header).append(0, "text"); }

  /// Writes over so many bytes at the beginning of the file.
  void damage(std::size_t bytes) const {
    std::string text = batch::read_whole_file(path_);
    std::fill_n(text.begin(), bytes, '\1');
    std::ofstream(path_) << text;
  }

  std::string refusal(const batch::JournalHeader& here) const {
    return message_of<ConfigError>([&] { refuse_journal_of_another(path_, here); });
  }
};

TEST_F(JournalHeaderOfAStudy, OfTheSameStudyAndBuildIsTaken) {
  write(journal_header(study_));
  EXPECT_NO_THROW(refuse_journal_of_another(path_, journal_header(study_)));
}

TEST_F(JournalHeaderOfAStudy, OfAnotherStudyIsRefusedWithTheKeysThatDiffer) {
  write(journal_header(study_));
  const std::string message = refusal(journal_header(SmallMap::config({"rotor.mass_kg=0.9"}).study));
  for (const char* part :
       {"holds finished cells of another configuration", "rotor.mass_kg", "0.8", "0.9", "--fresh"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST_F(JournalHeaderOfAStudy, OfAnotherBuildIsRefusedWithBothDigests) {
  write(journal_header(study_, "another"));
  const std::string message = refusal(journal_header(study_));
  EXPECT_NE(message.find("of another build of the program (digest another, this one has "), std::string::npos)
      << message;
}

TEST_F(JournalHeaderOfAStudy, WithAFirstLineThatIsDamagedIsTakenByTheOthers) {
  write(journal_header(study_));
  damage(4);
  EXPECT_NO_THROW(refuse_journal_of_another(path_, journal_header(study_)));
}

TEST_F(JournalHeaderOfAStudy, WithoutAnyHeaderIsLeftAsItIs) {
  write(journal_header(study_));
  damage(batch::read_whole_file(path_).size());
  const std::string before = batch::read_whole_file(path_);
  const std::string message =
      message_of<batch::DamagedJournal>([&] { refuse_journal_of_another(path_, journal_header(study_)); });
  EXPECT_NE(message.find("It is left as it is"), std::string::npos) << message;
  EXPECT_EQ(batch::read_whole_file(path_), before);
}

}  // namespace
}  // namespace rubsweep::map
