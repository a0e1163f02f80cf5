#include "rubsweep/map/verified_directory.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "batch/message_of.hpp"
#include "batch/read_whole_file.hpp"
#include "map/small_map.hpp"
#include "rubsweep/batch/result_files.hpp"
#include "rubsweep/config/study_digest.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/map/derived_files.hpp"

namespace rubsweep::map {
namespace {

VerifiedConfiguration read(const std::filesystem::path& file) {
  const sweep::Study study = config::read_run_config(file, {}).study;
  return {config::study_digest(study), study};
}

DirectoryVerdict verdict_on(const SmallMap& map) { return verify_directory(map.path, read); }

/// The one fault that must be there.
std::string fault_of(const SmallMap& map) {
  const DirectoryVerdict verdict = verdict_on(map);
  EXPECT_EQ(verdict.faults.size(), 1u);
  return verdict.faults.empty() ? "" : verdict.faults.front();
}

void expect_fault(const SmallMap& map, std::string_view text) {
  const std::string fault = fault_of(map);
  EXPECT_NE(fault.find(text), std::string::npos) << fault;
}

TEST(VerifiedDirectory, OfAWholeMapHasNoFault) {
  const SmallMap map;
  map.finish();
  const DirectoryVerdict verdict = verdict_on(map);
  EXPECT_TRUE(verdict.faults.empty());
  EXPECT_TRUE(verdict.remarks.empty());
  EXPECT_EQ(verdict.files, (std::vector<std::string>{"map.csv", "config.yaml"}));
}

TEST(VerifiedDirectory, KnowsCellsByTheirValuesInAnyOrder) {
  const SmallMap map;
  map.finish();
  map.give_rows({SmallMap::line(3), SmallMap::line(0), SmallMap::line(2), SmallMap::line(1)});
  const DirectoryVerdict verdict = verdict_on(map);
  EXPECT_TRUE(verdict.faults.empty()) << verdict.faults.front();
  EXPECT_EQ(verdict.remarks.size(), 1u);  // no checksum
  map.give_rows({SmallMap::line(3), SmallMap::line(0), SmallMap::line(2)});
  expect_fault(map, "there is no row of speed_hz 70, whirl_ratio 0.25");
  map.give_rows(
      {SmallMap::line(0), SmallMap::line(1), SmallMap::line(2), SmallMap::line(3), SmallMap::line(1)});
  expect_fault(map, "is there twice");
}

TEST(VerifiedDirectory, SeesAChangedByteAndAMissingEnd) {
  for (const bool cut : {true, false}) {
    const SmallMap map;
    map.finish();
    std::string table = batch::read_whole_file(map.path / "map.csv");
    if (cut) {
      table.resize(table.size() - 5);
    } else {
      table[table.size() - 3] = 'x';
    }
    std::ofstream(map.path / "map.csv") << table;
    expect_fault(map, "is not as it was written");
  }
}

TEST(VerifiedDirectory, SeesAConfigurationThatIsNotTheOneOfTheMap) {
  const SmallMap map;
  map.finish();
  std::string text = batch::read_whole_file(map.path / "config.yaml");
  const std::size_t at = text.find("mass_kg: 0.8");
  ASSERT_NE(at, std::string::npos);
  std::ofstream(map.path / "config.yaml") << text.replace(at, 12, "mass_kg: 0.9");
  expect_fault(map, "config.yaml: is not the one of map.csv");
  std::filesystem::remove(map.path / "config.yaml");
  expect_fault(map, "config.yaml: is missing");
}

TEST(VerifiedDirectory, SeesTablesOfAnotherStudyAndThoseThatAreGone) {
  const SmallMap map;
  map.finish();
  const auto write = [&](const std::string& digest) {
    batch::write_result_files({{slice_files[0], "x\n1\n"}, {slice_files[1], "y\n2\n"}}, slice_files, map.path,
                              {"rubbasin", digest});
  };
  write(config::study_digest(SmallMap::config().study));
  EXPECT_TRUE(verdict_on(map).faults.empty());
  std::filesystem::remove(map.path / "slice.csv");
  expect_fault(map, "slice.csv: is missing, it was written with attractors.csv");
  write("0123");
  EXPECT_EQ(verdict_on(map).faults.size(), 2u);
}

TEST(VerifiedDirectory, OfAnUnfinishedMapSaysSo) {
  const SmallMap map;
  map.begin().journal().append(0, SmallMap::line(0));
  const DirectoryVerdict verdict = verdict_on(map);
  ASSERT_FALSE(verdict.faults.empty());
  EXPECT_EQ(verdict.faults.front(), "map.journal: the map is not finished");
}

TEST(VerifiedDirectory, IsNotLookedAtWhileAProgramIsAtWork) {
  const SmallMap map;
  const MapDirectory directory = map.begin();
  EXPECT_NE(message_of<LockedError>([&] { verdict_on(map); }).find("is held by test"), std::string::npos);
}

TEST(VerifiedDirectory, KnowsTheProgramThatWroteIt) {
  const SmallMap map;
  EXPECT_FALSE(was_written_by("rubsweep", map.path));
  map.finish();
  EXPECT_TRUE(was_written_by("rubsweep", map.path));
  EXPECT_FALSE(was_written_by("ringstab", map.path));
}

}  // namespace
}  // namespace rubsweep::map
