#include "rubsweep/maps/batch/journal.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "maps/batch/failing_stat.hpp"
#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

using Cells = std::vector<std::pair<std::size_t, std::string>>;

const JournalHeader header{"study", "program", 20, "rotor:\n  mass_kg: 0.8\n"};

Cells cells_of(const std::filesystem::path& path, std::size_t damaged = 0) {
  Cells cells;
  EXPECT_EQ(read_journal(path, [&](const JournalRecord& r) { cells.emplace_back(r.cell, r.text); }), damaged);
  return cells;
}

class JournalFile : public testing::Test {
 protected:
  const TemporaryDirectory directory_;
  const std::filesystem::path path_ = directory_.path() / "map.journal";
};

TEST_F(JournalFile, KeepsItsHeader) {
  Journal(path_, header);
  const JournalHeader read = read_journal_header(path_);
  EXPECT_EQ(read.study_digest, header.study_digest);
  EXPECT_EQ(read.program_digest, header.program_digest);
  EXPECT_EQ(read.cells, header.cells);
  EXPECT_EQ(read.study, header.study);
  EXPECT_TRUE(same_results(read, header));
  for (const JournalHeader& other :
       {JournalHeader{"x", "program", 20, ""}, {"study", "x", 20, ""}, {"study", "program", 21, ""}}) {
    EXPECT_FALSE(same_results(other, header));
  }
}

TEST_F(JournalFile, KeepsCellsInTheOrderOfTheirEndAcrossRuns) {
  {
    Journal journal(path_, header);
    journal.append(7, "75,0.4,subharmonic");
    journal.append(0, "");
  }
  Journal(path_, header).append(19, "1 2 3");
  EXPECT_EQ(cells_of(path_), (Cells{{7, "75,0.4,subharmonic"}, {0, ""}, {19, "1 2 3"}}));
}

TEST_F(JournalFile, TheOffsetIsThatOfTheText) {
  Journal journal(path_, header);
  journal.append(3, "three");
  journal.append(12, "twelve");
  const std::string file = read_whole_file(path_);
  read_journal(path_,
               [&](const JournalRecord& r) { EXPECT_EQ(file.substr(r.offset, r.text.size()), r.text); });
}

TEST_F(JournalFile, CutAtAnyByteHoldsTheRecordsBeforeAndGoesOn) {
  Journal(path_, header);
  const std::size_t header_bytes = read_whole_file(path_).size();
  {
    Journal journal(path_, header);
    journal.append(1, "one");
    journal.append(2, "two");
  }
  const std::string whole = read_whole_file(path_);
  const std::size_t first_end = whole.find('\n', header_bytes) + 1;
  for (std::size_t length = header_bytes; length <= whole.size(); ++length) {
    write_whole_file(path_, whole.substr(0, length));
    Cells expected;
    if (length >= first_end) expected.emplace_back(1, "one");
    if (length == whole.size()) expected.emplace_back(2, "two");
    EXPECT_EQ(cells_of(path_), expected) << length;
    Journal(path_, header).append(5, "five");
    expected.emplace_back(5, "five");
    EXPECT_EQ(cells_of(path_), expected) << length;
  }
}

TEST_F(JournalFile, AChangedByteCostsOneRecord) {
  {
    Journal journal(path_, header);
    journal.append(1, "one");
  }
  const std::size_t begin = read_whole_file(path_).size();
  Journal(path_, header).append(2, "two");
  const std::size_t end = read_whole_file(path_).size();
  Journal(path_, header).append(3, "three");
  const std::string whole = read_whole_file(path_);
  for (std::size_t place = begin; place + 1 < end; ++place) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    write_whole_file(path_, changed);
    EXPECT_EQ(cells_of(path_, 1), (Cells{{1, "one"}, {3, "three"}})) << place;
  }
}

TEST_F(JournalFile, CellsOutsideTheGridAreDamaged) {
  Journal(path_, header).append(20, "twenty");
  EXPECT_EQ(cells_of(path_, 1), Cells{});
}

TEST_F(JournalFile, WithoutAWholeHeaderIsRefused) {
  Journal(path_, header);
  const std::string whole = read_whole_file(path_);
  for (const std::size_t length : {std::size_t{0}, std::size_t{5}, whole.size() / 2, whole.size() - 1}) {
    write_whole_file(path_, whole.substr(0, length));
    EXPECT_NE(
        message_of<IoError>([&] { read_journal_header(path_); }).find(": not a journal of this program"),
        std::string::npos);
  }
  write_whole_file(path_, "speed_hz,whirl_ratio\n");
  EXPECT_EQ(message_of<IoError>([&] { read_journal_header(path_); }),
            path_.string() + ":1: not a journal of this program, or a damaged one");
}

/// The text with one letter of line `number`, counted from 1, changed.
std::string damaged(std::string text, int number) {
  std::size_t place = 0;
  for (; number > 1; --number) place = text.find('\n', place) + 1;
  text[place + 9] ^= 1;  // a byte after the checksum
  return text;
}

TEST_F(JournalFile, ADamagedHeaderCostsNothingWhereTheRestSaysEnough) {
  {
    Journal journal(path_, header);
    journal.append(3, "three");
    journal.append(12, "twelve");
  }
  const std::string whole = read_whole_file(path_);
  const Cells all{{3, "three"}, {12, "twelve"}};
  // The first line, the digest of the study, the study, and the line before the records.
  for (const int line : {1, 2, 5, 6, 7}) {
    write_whole_file(path_, damaged(whole, line));
    const JournalHeader read = read_journal_header(path_);
    EXPECT_EQ(read.damaged_lines, 1u) << line;
    EXPECT_TRUE(same_results(read, header)) << line;
    EXPECT_FALSE(same_results(read, {"other", "program", 20, "rotor:\n  mass_kg: 0.9\n"})) << line;
    EXPECT_EQ(cells_of(path_), all) << line;
    Journal(path_, header);
    EXPECT_EQ(read_whole_file(path_), damaged(whole, line)) << line;
  }
  // The program's digest, the number of cells, digest and study together, and every line end.
  std::vector<std::string> hopeless{damaged(whole, 3), damaged(whole, 4), damaged(damaged(whole, 2), 5)};
  for (std::size_t end = whole.find('\n'); hopeless.size() < 6; end = whole.find('\n', end + 1)) {
    hopeless.push_back(whole);
    hopeless.back()[end] ^= 1;
  }
  for (const std::string& text : hopeless) {
    write_whole_file(path_, text);
    EXPECT_NE(message_of<DamagedJournal>([&] { read_journal_header(path_); }).find("a damaged one"),
              std::string::npos)
        << text;
    EXPECT_EQ(read_whole_file(path_), text);
  }
}

TEST_F(JournalFile, ThatCannotBeLookedAtIsNotBegunAnew) {
  Journal(path_, header).append(1, "one");
  const std::string before = read_whole_file(path_);
  {
    const FailingStat trouble;
    EXPECT_EQ(message_of<IoError>([&] { Journal(path_, header); }),
              "cannot look at " + path_.string() + ": Input/output error");
  }
  EXPECT_EQ(read_whole_file(path_), before);
}

TEST_F(JournalFile, KeepsSingleLines) {
  Journal journal(path_, header);
  EXPECT_EQ(message_of<SolverError>([&] { journal.append(1, "two\nlines"); }),
            "a journal keeps single lines");
}

TEST_F(JournalFile, ThatCannotBeWrittenIsAnError) {
  EXPECT_EQ(message_of<IoError>([] { Journal("/nowhere/map.journal", header); }),
            "cannot write /nowhere/map.journal: No such file or directory");
}

using CellNumbers = std::vector<std::size_t>;

const JournalHeader of_six_cells{"study", "program", 6, ""};

TEST(JournalFinishedCells, WithoutJournalsEverythingIsMissing) {
  const FinishedCells cells(6);
  EXPECT_EQ(cells.count(), 0u);
  EXPECT_EQ(cells.missing(), (CellNumbers{0, 1, 2, 3, 4, 5}));
}

TEST(JournalFinishedCells, AreThoseOfAllJournals) {
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
