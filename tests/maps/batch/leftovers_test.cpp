#include "rubsweep/maps/batch/leftovers.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {
namespace {

std::set<std::string> names_in(const std::filesystem::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    names.insert(entry.path().filename());
  return names;
}

TEST(Leftovers, GoWhereTheirNameIsOneOfOurs) {
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

TEST(Leftovers, StayWhileSomebodyWritesThem) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "edges.csv";
  WholeFile file(path);
  file.write("text");
  remove_leftovers(directory.path(), [](std::string_view) { return true; });
  file.commit();
  EXPECT_EQ(names_in(directory.path()), std::set<std::string>{"edges.csv"});
}

TEST(Leftovers, GoWhenTheirFileIsBegunAnew) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "picture.svg.tmp-host-12") << "text";
  std::ofstream(directory.path() / "other.svg.tmp-host-12") << "text";
  write_whole_file(directory.path() / "picture.svg", "text");
  EXPECT_EQ(names_in(directory.path()), (std::set<std::string>{"picture.svg", "other.svg.tmp-host-12"}));
}

}  // namespace
}  // namespace rubsweep::batch
