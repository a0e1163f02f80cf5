#include "rubsweep/maps/batch/table_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <string>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

class TableFileTest : public testing::Test {
 protected:
  void write(const std::string& text, const TableSource& source = {"rubsweep 1.2.3", "abc", {}}) const {
    TableFile file(path_, source);
    file.write(text);
    file.commit();
  }

  void put(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }

  /// The table with the first `old` replaced by `what`.
  std::string changed(const std::string& old, const std::string& what) const {
    std::string text = read_whole_file(path_);
    return text.replace(text.find(old), old.size(), what);
  }

  TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "table.csv";
};

/// The checksum equals that of `sed '/^# sha256 /d' table.csv | sha256sum`.
TEST_F(TableFileTest, HasAHeadWithTheSumOfAllOtherLines) {
  write("# along x\na,b\n1,2\n", {"rubline 1.2.3", "abc", {"config.yaml", "table.csv"}});
  EXPECT_EQ(read_whole_file(path_),
            "# rubline 1.2.3\n# digest abc\n# format 1\n# files config.yaml table.csv\n"
            "# sha256 3ff4c5010df527ecf7a2f3dc8b4d3622fddb025e152e27da578aa2639a7acb4f\n"
            "# along x\na,b\n1,2\n");
  EXPECT_EQ(check_table(path_), TableSum::right);
}

TEST_F(TableFileTest, CaptionsStandInTheHead) {
  write("a\n1\n", {"rubsweep 1.2.3", "abc", {}, "# title sha256 of nothing\n"});
  EXPECT_TRUE(read_whole_file(path_).starts_with(
      "# rubsweep 1.2.3\n# digest abc\n# format 1\n# title sha256 of nothing\n# sha256 "));
  EXPECT_EQ(check_table(path_), TableSum::right);
}

TEST_F(TableFileTest, AnyOtherByteIsFound) {
  write("a,b\n1.5,word\n2.5,\n");
  const std::string whole = read_whole_file(path_);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string other = whole;
    other[i] = other[i] == '7' ? '8' : '7';
    put(other);
    // Without its keyword the checksum's line is an ordinary comment, but the format requires a checksum.
    EXPECT_THROW(check_table(path_), IoError) << i;
    if (i + 1 == whole.size()) break;
    put(whole.substr(0, i + 1));
    const bool says_no_format = i < whole.find("# format ") + 8;
    if (says_no_format) continue;
    EXPECT_THROW(check_table(path_), IoError) << i;
  }
}

TEST_F(TableFileTest, AMessageSaysWhatIsWrong) {
  write("a,b\n1,2\n");
  const auto problem = [&](const std::string& text) {
    put(text);
    return message_of<DamagedTable>([&] { check_table(path_); });
  };
  const std::string begin = path_.string() + ": is not as it was written: ";
  EXPECT_TRUE(
      problem(changed("1,2\n", "1,2")).starts_with(begin + "its last line has no end, its sha256 is "));
  write("a,b\n1,2\n");
  EXPECT_TRUE(problem(changed("1,2", "1,3")).starts_with(begin + "its sha256 is "));
  write("a,b\n1,2\n");
  EXPECT_EQ(problem(changed("# sha256 ", "# sum ")), begin + "its checksum is missing");
  write("a,b\n1,2\n");
  put(changed("# format 1", "# format 2"));
  EXPECT_EQ(message_of<IoError>([&] { check_table(path_); }),
            path_.string() + ": is a table of format 2, allowed: those up to 1, or a later program");
}

/// Line ends may change when git checks out files on another system.
TEST_F(TableFileTest, EndsOfLinesInCrLfChangeNothing) {
  write("a,b\n1,\"x\ny\"\n", {"rubline 1.2.3", "abc", {}});
  std::string text = read_whole_file(path_), other;
  for (const char c : text) other += c == '\n' ? "\r\n" : std::string(1, c);
  put(other);
  EXPECT_EQ(check_table(path_), TableSum::right);
  EXPECT_EQ(check_table_text(other, path_), TableSum::right);
  other[other.find("1,\"")] = '2';
  put(other);
  EXPECT_THROW(check_table(path_), DamagedTable);
  EXPECT_THROW(check_table_text(other, path_), DamagedTable);
  put(text.insert(text.find("a,b") + 3, "\r"));  // in a single line
  EXPECT_THROW(check_table(path_), DamagedTable);
}

TEST_F(TableFileTest, OneThatGrowsHasNone) {
  const auto path = directory_.path() / "map.partial.csv";
  std::ofstream(path) << table_head({"rubsweep 1", "abc", {}}) << "a\n1\n";
  EXPECT_EQ(check_table(path), TableSum::none);
}

TEST_F(TableFileTest, AnEarlierTableHasNone) {
  put("# rubsweep 0.1\n# digest abc\na,b\n1,2\n");
  EXPECT_EQ(check_table(path_), TableSum::none);
  put("");
  EXPECT_EQ(check_table(path_), TableSum::none);
  EXPECT_THROW(check_table(directory_.path() / "nowhere.csv"), IoError);
}

constexpr std::array<std::string_view, 3> names{"a.csv", "b.csv", "config.yaml"};
const ResultSource source{"rubtest", "0123"};

TEST(TableFileResultFiles, TablesNameTheProgramTheStudyAndEachOther) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}, {"config.yaml", "mass_kg: 1\n"}}, names, directory.path(), source);
  const std::string table = read_whole_file(directory.path() / "a.csv");
  EXPECT_TRUE(table.starts_with("# rubtest ")) << table;
  for (const char* part : {"# digest 0123\n", "# files a.csv config.yaml\n", "\nx\n1\n"})
    EXPECT_NE(table.find(part), std::string::npos) << part;
  EXPECT_EQ(check_table(directory.path() / "a.csv"), TableSum::right);
  EXPECT_EQ(read_whole_file(directory.path() / "config.yaml"), "mass_kg: 1\n");
}

TEST(TableFileResultFiles, ATableTellsTheSumOfWhatHasNoPlaceForIt) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}, {"config.yaml", "mass_kg: 1\n"}}, names, directory.path(),
                     {"rubtest", "0123", {}, {"map.csv"}});
  const std::string table = read_whole_file(directory.path() / "a.csv");
  // from: printf 'mass_kg: 1\n' | sha256sum
  EXPECT_NE(table.find("\n# files a.csv config.yaml map.csv\n# sum config.yaml "
                       "888f12b1da7b03f43005841318ad34d884a973aeb34ec063086ce4eecf99333a\n"),
            std::string::npos)
      << table;
}

TEST(TableFileResultFiles, AFileOfAnEarlierRunDoesNotStayBesideANewOne) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}, {"b.csv", "y\n2\n"}}, names, directory.path(), source);
  std::ofstream(directory.path() / "notes.txt") << "of a person";
  write_result_files({{"b.csv", "y\n3\n"}}, names, directory.path(), source);
  EXPECT_FALSE(fs::exists(directory.path() / "a.csv"));
  EXPECT_TRUE(read_whole_file(directory.path() / "b.csv").ends_with("y\n3\n"));
  EXPECT_TRUE(fs::exists(directory.path() / "notes.txt"));
}

TEST(TableFileResultFiles, ALinkStaysAndTheFileBehindItIsReplaced) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "kept_elsewhere.csv") << "old";
  fs::create_symlink(directory.path() / "kept_elsewhere.csv", directory.path() / "a.csv");
  write_result_files({{"a.csv", "x\n1\n"}}, names, directory.path(), source);
  EXPECT_TRUE(fs::is_symlink(directory.path() / "a.csv"));
  EXPECT_TRUE(read_whole_file(directory.path() / "kept_elsewhere.csv").ends_with("x\n1\n"));
}

TEST(TableFileResultFiles, WhereOneCannotBeWrittenTheOldOnesStay) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}}, names, directory.path(), source);
  const std::string before = read_whole_file(directory.path() / "a.csv");
  fs::create_symlink(directory.path() / "nowhere" / "b.csv", directory.path() / "b.csv");
  EXPECT_THROW(write_result_files({{"a.csv", "x\n2\n"}, {"b.csv", "y\n"}}, names, directory.path(), source),
               IoError);
  EXPECT_EQ(read_whole_file(directory.path() / "a.csv"), before);
}

TEST(TableFileResultFiles, RemovesFilesAndTheTemporariesOfKilledProcesses) {
  const TemporaryDirectory directory;
  for (const char* name : {"a.csv", "b.csv.tmp-host-12"}) std::ofstream(directory.path() / name) << "old";
  remove_result_files(names, directory.path());
  EXPECT_TRUE(fs::is_empty(directory.path()));
}

TEST(TableFileResultFiles, ADirectoryBesideTheMapHasItsNameAndAnEnding) {
  EXPECT_EQ(directory_beside("results/map", "_trace"), "results/map_trace");
  EXPECT_EQ(directory_beside("results/map/", "_trace"), "results/map_trace");
}

TEST(TableFileResultFiles, TheirLineNamesThemInOrder) {
  EXPECT_EQ(files_line({{"b.csv", ""}, {"a.csv", ""}}, "here"), "files     here: a.csv b.csv\n");
}

TEST(TableFileCaptionLines, AreCommentsHoweverManyLinesANoteHas) {
  EXPECT_EQ(caption_lines({"T", "A", "one\n\nspeed_hz,class\n"}),
            "# title T\n# author A\n# note one\n# note\n# note speed_hz,class\n");
  EXPECT_EQ(caption_lines({}), "");
}

}  // namespace
}  // namespace rubsweep::batch
