#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "maps/batch/failing_stat.hpp"
#include "maps/batch/failing_sync.hpp"
#include "maps/batch/file_size_limit.hpp"
#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

TEST(WholeFileLineLog, EachLineIsThereAtOnce) {
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

/// The last line is synced when its time has passed, with or without another line, and not earlier.
TEST(WholeFileLineLog, RefreshSyncsWhatWasAppendedOnceItsTimeIsOver) {
  const TemporaryDirectory directory;
  LineLog log(directory.path() / "map.partial.csv", std::chrono::milliseconds(50));
  const FailingSync syncs;
  log.append("1,2");
  log.refresh();
  EXPECT_EQ(syncs.calls(), 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  log.refresh();
  EXPECT_EQ(syncs.calls(), 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  log.refresh();
  EXPECT_EQ(syncs.calls(), 1) << "nothing was appended since";
}

TEST(WholeFileLineLog, AFailureToSyncIsWhatTheNextLineThrows) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.partial.csv";
  LineLog log(path);
  log.append("1,2");
  {
    const FailingSync syncs;
    log.sync();
  }
  EXPECT_EQ(message_of<IoError>([&] { log.append("3,4"); }),
            "cannot write " + path.string() + ": Input/output error");
  log.append("5,6");
}

TEST(WholeFileLineLog, GoesOnAfterTheLastWholeLine) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.partial.csv";
  const std::string longer_than_a_block(10000, 'x');
  for (const auto& [before, after] : {std::pair<std::string, std::string>{"a\nb\n", "a\nb\nnext\n"},
                                      {"a\nb\n1.23", "a\nb\nnext\n"},
                                      {"torn", "next\n"},
                                      {"", "next\n"},
                                      {"a\n" + longer_than_a_block, "a\nnext\n"},
                                      {longer_than_a_block, "next\n"},
                                      {longer_than_a_block + "\n", longer_than_a_block + "\nnext\n"}}) {
    write_whole_file(path, before);
    LineLog(path).append("next");
    EXPECT_EQ(read_whole_file(path), after);
  }
}

TEST(WholeFileLineLog, ALineThatDoesNotFitLeavesNothingBehind) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.partial.csv";
  LineLog log(path);
  log.append("1,2");
  {
    const FileSizeLimit limit(10);
    EXPECT_EQ(message_of<IoError>([&] { log.append("a line of many bytes"); }),
              "cannot write " + path.string() + ": File too large");
  }
  EXPECT_EQ(read_whole_file(path), "1,2\n");
  log.append("3,4");
  EXPECT_EQ(read_whole_file(path), "1,2\n3,4\n");
}

TEST(WholeFileLineLog, AFileThatCannotBeLookedAtIsNotTakenForAnEmptyOne) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.journal";
  write_whole_file(path, "a\nb\n");
  const std::string expected = "cannot look at " + path.string() + ": Input/output error";
  {
    const FailingStat trouble;
    EXPECT_EQ(message_of<IoError>([&] { LineLog log(path); }), expected);
  }
  EXPECT_EQ(read_whole_file(path), "a\nb\n");
  LineLog log(path);
  {
    const FailingStat trouble;
    EXPECT_EQ(message_of<IoError>([&] { log.append("c"); }), expected);
  }
  EXPECT_EQ(read_whole_file(path), "a\nb\n");
}

TEST(WholeFileLineLog, FailuresAreErrors) {
  EXPECT_EQ(message_of<IoError>([] { LineLog("/nowhere/map.partial.csv"); }),
            "cannot write /nowhere/map.partial.csv: No such file or directory");
  LineLog full("/dev/full");
  EXPECT_EQ(message_of<IoError>([&] { full.append("1,2"); }),
            "cannot write /dev/full: No space left on device");
}

}  // namespace
}  // namespace rubsweep::batch
