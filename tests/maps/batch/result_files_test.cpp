#include "rubsweep/maps/batch/result_files.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> names{"a.csv", "b.csv", "config.yaml"};
const ResultSource source{"rubtest", "0123"};

TEST(ResultFiles, TablesNameTheProgramTheStudyAndEachOther) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}, {"config.yaml", "mass_kg: 1\n"}}, names, directory.path(), source);
  const std::string table = read_whole_file(directory.path() / "a.csv");
  EXPECT_TRUE(table.starts_with("# rubtest ")) << table;
  for (const char* part : {"# digest 0123\n", "# files a.csv config.yaml\n", "\nx\n1\n"})
    EXPECT_NE(table.find(part), std::string::npos) << part;
  EXPECT_EQ(check_table(directory.path() / "a.csv"), TableSum::right);
  EXPECT_EQ(read_whole_file(directory.path() / "config.yaml"), "mass_kg: 1\n");
}

TEST(ResultFiles, ATableTellsTheSumOfWhatHasNoPlaceForIt) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}, {"config.yaml", "mass_kg: 1\n"}}, names, directory.path(),
                     {"rubtest", "0123", {}, {"map.csv"}});
  const std::string table = read_whole_file(directory.path() / "a.csv");
  // printf 'mass_kg: 1\n' | sha256sum
  EXPECT_NE(table.find("\n# files a.csv config.yaml map.csv\n# sum config.yaml "
                       "888f12b1da7b03f43005841318ad34d884a973aeb34ec063086ce4eecf99333a\n"),
            std::string::npos)
      << table;
}

TEST(ResultFiles, AFileOfAnEarlierRunDoesNotStayBesideANewOne) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}, {"b.csv", "y\n2\n"}}, names, directory.path(), source);
  std::ofstream(directory.path() / "notes.txt") << "of a person";
  write_result_files({{"b.csv", "y\n3\n"}}, names, directory.path(), source);
  EXPECT_FALSE(fs::exists(directory.path() / "a.csv"));
  EXPECT_TRUE(read_whole_file(directory.path() / "b.csv").ends_with("y\n3\n"));
  EXPECT_TRUE(fs::exists(directory.path() / "notes.txt"));
}

TEST(ResultFiles, ALinkStaysAndTheFileBehindItIsReplaced) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "kept_elsewhere.csv") << "old";
  fs::create_symlink(directory.path() / "kept_elsewhere.csv", directory.path() / "a.csv");
  write_result_files({{"a.csv", "x\n1\n"}}, names, directory.path(), source);
  EXPECT_TRUE(fs::is_symlink(directory.path() / "a.csv"));
  EXPECT_TRUE(read_whole_file(directory.path() / "kept_elsewhere.csv").ends_with("x\n1\n"));
}

TEST(ResultFiles, WhereOneCannotBeWrittenTheOldOnesStay) {
  const TemporaryDirectory directory;
  write_result_files({{"a.csv", "x\n1\n"}}, names, directory.path(), source);
  const std::string before = read_whole_file(directory.path() / "a.csv");
  fs::create_symlink(directory.path() / "nowhere" / "b.csv", directory.path() / "b.csv");
  EXPECT_THROW(write_result_files({{"a.csv", "x\n2\n"}, {"b.csv", "y\n"}}, names, directory.path(), source),
               IoError);
  EXPECT_EQ(read_whole_file(directory.path() / "a.csv"), before);
}

TEST(ResultFiles, RemovesFilesAndTheTemporariesOfKilledProcesses) {
  const TemporaryDirectory directory;
  for (const char* name : {"a.csv", "b.csv.tmp-host-12"}) std::ofstream(directory.path() / name) << "old";
  remove_result_files(names, directory.path());
  EXPECT_TRUE(fs::is_empty(directory.path()));
}

TEST(ResultFiles, ADirectoryBesideTheMapHasItsNameAndAnEnding) {
  EXPECT_EQ(directory_beside("results/map", "_trace"), "results/map_trace");
  EXPECT_EQ(directory_beside("results/map/", "_trace"), "results/map_trace");
}

TEST(ResultFiles, TheirLineNamesThemInOrder) {
  EXPECT_EQ(files_line({{"b.csv", ""}, {"a.csv", ""}}, "here"), "files     here: a.csv b.csv\n");
}

}  // namespace
}  // namespace rubsweep::batch
