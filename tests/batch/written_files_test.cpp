#include "rubsweep/batch/written_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "batch/temporary_directory.hpp"
#include "rubsweep/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

TEST(WrittenFiles, AreThoseThatWereCommittedEachOnceAndAreStillThere) {
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

}  // namespace
}  // namespace rubsweep::batch
