#include "rubsweep/maps/batch/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "maps/batch/file_size_limit.hpp"
#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entries(const std::filesystem::path& directory) {
  return std::distance(std::filesystem::directory_iterator(directory), {});
}

TEST(WholeFileWrite, HoldsExactlyTheTextAndNothingStaysBeside) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  const std::string long_text(300000, 'x');
  for (const std::string& text :
       {std::string("a,b\n1,2\n"), long_text, std::string("\0\r\n", 3), std::string()}) {
    write_whole_file(path, text);
    EXPECT_EQ(read_whole_file(path), text);
    EXPECT_EQ(entries(directory.path()), 1);
  }
}

TEST(WholeFileWrite, HasTheUsualPermissions) {
  const TemporaryDirectory directory;
  const mode_t mask = ::umask(022);
  write_whole_file(directory.path() / "map.csv", "text");
  ::umask(mask);
  EXPECT_EQ(std::filesystem::status(directory.path() / "map.csv").permissions(),
            std::filesystem::perms(0644));
}

TEST(WholeFileWrite, ReplacesRatherThanOverwrites) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  write_whole_file(path, "old");
  std::ifstream reader(path);
  write_whole_file(path, "new");
  std::string seen;
  reader >> seen;
  EXPECT_EQ(seen, "old") << "who had the file open must not see it change";
  EXPECT_EQ(read_whole_file(path), "new");
}

TEST(WholeFileWrite, KeepsALinkAndRefusesWhatIsNoFile) {
  const TemporaryDirectory directory;
  const auto target = directory.path() / "target", link = directory.path() / "link",
             pipe = directory.path() / "pipe";
  std::filesystem::create_symlink("target", link);
  write_whole_file(link, "first");
  write_whole_file(link, "second");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_whole_file(target), "second");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(message_of<IoError>([&] { write_whole_file(pipe, "text"); }),
            pipe.string() + ": is not a regular file");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(WholeFileWrite, MissingDirectoryIsAnError) {
  EXPECT_EQ(message_of<IoError>([] { write_whole_file("/nowhere/map.csv", "text"); }),
            "cannot write /nowhere/map.csv: No such file or directory");
}

TEST(WholeFileWrite, LeavesNothingWhenTheDiskIsFull) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  write_whole_file(path, "old");
  {
    const FileSizeLimit limit(1000);
    EXPECT_EQ(message_of<IoError>([&] { write_whole_file(path, std::string(5000, 'x')); }),
              "cannot write " + path.string() + ": File too large");
  }
  EXPECT_EQ(read_whole_file(path), "old");
  EXPECT_EQ(entries(directory.path()), 1);
}

TEST(WholeFileWrite, LeavesNothingWhenTheNameIsTaken) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  std::filesystem::create_directory(path);
  EXPECT_EQ(message_of<IoError>([&] { write_whole_file(path, "text"); }),
            "cannot write " + path.string() + ": Is a directory");
  EXPECT_EQ(entries(directory.path()), 1);
}

TEST(WholeFile, IsThereOnlyOnceItIsCommitted) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  write_whole_file(path, "old");
  const std::string longer_than_the_buffer(100000, 'x');
  {
    WholeFile file(path);
    file.write("begin ");
    file.write(longer_than_the_buffer);
    file.write(" end");
    EXPECT_EQ(read_whole_file(path), "old");
    file.commit();
    EXPECT_EQ(read_whole_file(path), "begin " + longer_than_the_buffer + " end");
  }
  EXPECT_EQ(entries(directory.path()), 1);
}

TEST(WholeFile, IsWholeOnTheDiskBeforeItHasItsName) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  WholeFile file(path);
  file.write("digits follow: 00");
  file.write_at(15, "42");
  file.finish();
  EXPECT_FALSE(std::filesystem::exists(path));
  file.rename();
  EXPECT_EQ(read_whole_file(path), "digits follow: 42");
}

TEST(WholeFile, ThatIsGivenUpLeavesTheOlderOne) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  write_whole_file(path, "old");
  WholeFile(path).write("new");
  EXPECT_EQ(read_whole_file(path), "old");
  EXPECT_EQ(entries(directory.path()), 1);
}

TEST(WholeFileWrittenFiles, AreThoseThatWereCommittedEachOnceAndAreStillThere) {
  const TemporaryDirectory directory;
  const fs::path kept = directory.path() / "kept", removed = directory.path() / "removed",
                 given_up = directory.path() / "given_up";
  const auto count = [](const fs::path& path) { return std::ranges::count(written_files(), path); };
  write_whole_file(kept, "a");
  write_whole_file(removed, "b");
  write_whole_file(kept, "c");
  { WholeFile file(given_up); }
  EXPECT_EQ(count(kept), 1);
  EXPECT_EQ(count(removed), 1);
  EXPECT_EQ(count(given_up), 0);
  const auto files = written_files();
  EXPECT_LT(std::ranges::find(files, kept), std::ranges::find(files, removed));
  fs::remove(removed);
  EXPECT_EQ(count(removed), 0);
}

std::set<std::string> names_in(const std::filesystem::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    names.insert(entry.path().filename());
  return names;
}

TEST(WholeFileLeftovers, GoWhereTheirNameIsOneOfOurs) {
  const TemporaryDirectory directory;
  for (const char* name :
       {"line.csv.tmp-host-12", "line.csv.tmp-other-host-7", "line.csv", "line.csv.tmp-old",
        "line.csv.tmp-2026-11-28a", "mine.tmp-host-12", "line.csv.tmp", "tmp-host-12"})
    std::ofstream(directory.path() / name) << "text";
  remove_leftovers(directory.path(), [](std::string_view name) { return name == "line.csv"; });
  EXPECT_EQ(names_in(directory.path()),
            (std::set<std::string>{"line.csv", "line.csv.tmp-old", "line.csv.tmp-2026-11-28a",
                                   "mine.tmp-host-12", "line.csv.tmp", "tmp-host-12"}));
  remove_leftovers("/nowhere", [](std::string_view) { return true; });
}

TEST(WholeFileLeftovers, StayWhileSomebodyWritesThem) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "edges.csv";
  WholeFile file(path);
  file.write("text");
  remove_leftovers(directory.path(), [](std::string_view) { return true; });
  file.commit();
  EXPECT_EQ(names_in(directory.path()), std::set<std::string>{"edges.csv"});
}

TEST(WholeFileLeftovers, GoWhenTheirFileIsBegunAnew) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "picture.svg.tmp-host-12") << "text";
  std::ofstream(directory.path() / "other.svg.tmp-host-12") << "text";
  write_whole_file(directory.path() / "picture.svg", "text");
  EXPECT_EQ(names_in(directory.path()), (std::set<std::string>{"picture.svg", "other.svg.tmp-host-12"}));
}

}  // namespace
}  // namespace rubsweep::batch
