#include "rubsweep/batch/whole_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

#include "batch/message_of.hpp"
#include "batch/temporary_directory.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::batch {
namespace {

std::ptrdiff_t entries(const std::filesystem::path& directory) {
  return std::distance(std::filesystem::directory_iterator(directory), {});
}

/// While it lives, no file of this process may grow beyond `bytes`; writing more fails with "File too large".
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{.rlim_cur = bytes, .rlim_max = old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    ::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  sighandler_t old_handler_;
  rlimit old_{};
};

TEST(WriteWholeFile, HoldsExactlyTheTextAndNothingStaysBeside) {
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

TEST(WriteWholeFile, HasTheUsualPermissions) {
  const TemporaryDirectory directory;
  const mode_t mask = ::umask(022);
  write_whole_file(directory.path() / "map.csv", "text");
  ::umask(mask);
  EXPECT_EQ(std::filesystem::status(directory.path() / "map.csv").permissions(),
            std::filesystem::perms(0644));
}

TEST(WriteWholeFile, ReplacesRatherThanOverwrites) {
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

TEST(WriteWholeFile, MissingDirectoryIsAnError) {
  EXPECT_EQ(message_of<IoError>([] { write_whole_file("/nowhere/map.csv", "text"); }),
            "cannot write /nowhere/map.csv: No such file or directory");
}

TEST(WriteWholeFile, LeavesNothingWhenTheDiskIsFull) {
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

TEST(WriteWholeFile, LeavesNothingWhenTheNameIsTaken) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  std::filesystem::create_directory(path);
  EXPECT_EQ(message_of<IoError>([&] { write_whole_file(path, "text"); }),
            "cannot write " + path.string() + ": Is a directory");
  EXPECT_EQ(entries(directory.path()), 1);
}

TEST(ReadWholeFile, SaysWhyItCannot) {
  const TemporaryDirectory directory;
  EXPECT_EQ(message_of<IoError>([&] { read_whole_file(directory.path()); }),
            "cannot read " + directory.path().string() + ": Is a directory");
}

TEST(LineLog, EachLineIsThereAtOnce) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.partial.csv";
  LineLog log(path);
  EXPECT_EQ(read_whole_file(path), "");
  log.append("a,b");
  EXPECT_EQ(read_whole_file(path), "a,b\n");
  log.append("");
  log.append("1,2");
  EXPECT_EQ(read_whole_file(path), "a,b\n\n1,2\n");
}

TEST(LineLog, GoesOnAfterTheLastWholeLine) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.partial.csv";
  for (const auto& [before, after] :
       {std::pair{"a\nb\n", "a\nb\nnext\n"}, std::pair{"a\nb\n1.23", "a\nb\nnext\n"},
        std::pair{"torn", "next\n"}, std::pair{"", "next\n"}}) {
    write_whole_file(path, before);
    LineLog(path).append("next");
    EXPECT_EQ(read_whole_file(path), after);
  }
}

TEST(LineLog, FailuresAreErrors) {
  EXPECT_EQ(message_of<IoError>([] { LineLog("/nowhere/map.partial.csv"); }),
            "cannot write /nowhere/map.partial.csv: No such file or directory");
  LineLog full("/dev/full");
  EXPECT_EQ(message_of<IoError>([&] { full.append("1,2"); }),
            "cannot write /dev/full: No space left on device");
}

}  // namespace
}  // namespace rubsweep::batch
