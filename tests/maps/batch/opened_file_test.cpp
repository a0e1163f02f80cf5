#include "rubsweep/maps/batch/opened_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {
namespace {

TEST(OpenedFileDirectoryMake, MakesThoseAboveAsWell) {
  const TemporaryDirectory directory;
  for (const char* name : {"a/b/c", "a/b/c/", "./d/../e"}) {
    make_directory(directory.path() / name);
    EXPECT_TRUE(std::filesystem::is_directory(directory.path() / name)) << name;
    make_directory(directory.path() / name);  // the directory already exists
  }
  std::filesystem::create_directory_symlink("a/b", directory.path() / "link");
  make_directory(directory.path() / "link/f");
  EXPECT_TRUE(std::filesystem::is_directory(directory.path() / "a/b/f"));
}

TEST(OpenedFileDirectoryMake, AFileInItsWayIsAnError) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "file") << "text";
  EXPECT_THROW(make_directory(directory.path() / "file"), IoError);
  EXPECT_THROW(make_directory(directory.path() / "file/below"), IoError);
}

TEST(OpenedFileDirectorySync, OfOneThatIsNotThereIsAnError) {
  const TemporaryDirectory directory;
  EXPECT_NO_THROW(sync_directory(directory.path()));
  EXPECT_THROW(sync_directory(directory.path() / "nowhere"), IoError);
}

}  // namespace
}  // namespace rubsweep::batch
