#include "shared/verified_directory.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <fstream>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_files.hpp"
#include "shared/written_file.hpp"

namespace rubsweep::apps {

using namespace map;

namespace {

VerifiedConfiguration read(const std::filesystem::path& file) {
  const sweep::Study study = config::read_run_config(file, {}).study;
  return {config::study_digest(study), study};
}

DirectoryVerdict verdict_on(const SmallMap& map) { return verify_directory(map.path, read); }

/// The fault found; there must be exactly one.
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
  EXPECT_EQ(verdict.remarks.size(), 1u);  // the missing checksum
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

/// Files written by a program without a map; `program` is its name.
struct Written {
  TemporaryDirectory directory;
  const std::filesystem::path& path = directory.path();
  static constexpr std::array<std::string_view, 3> names{"config.yaml", "answer.json", "answer.csv"};

  explicit Written(const std::string& program) {
    batch::write_result_files(
        {{names[0], config::print_config(SmallMap::config({"rotor.damping_ratio=0.05"}))},
         {names[1], "{\"probability\": 0}\n"},
         {names[2], "x\n1\n"}},
        names, path, {program, config::study_digest(SmallMap::config().study)});
  }
  void put(const char* name, std::string_view text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  DirectoryVerdict verdict() const { return verify_directory(path, read); }
  void expect_fault(std::string_view text) const {
    const DirectoryVerdict found = verdict();
    ASSERT_EQ(found.faults.size(), 1u);
    EXPECT_NE(found.faults.front().find(text), std::string::npos) << found.faults.front();
  }
};

/// A fit's directory contains the resulting configuration, not the one that was read.
TEST(VerifiedDirectory, OfAFitIsWhole) {
  const Written fit("rubfit");
  EXPECT_TRUE(fit.verdict().faults.empty()) << fit.verdict().faults.front();
  EXPECT_EQ(fit.verdict().files, (std::vector<std::string>{"answer.csv", "answer.json", "config.yaml"}));
  fit.put("config.yaml", config::print_config(SmallMap::config({"rotor.damping_ratio=0.06"})));
  fit.expect_fault("config.yaml: is not as it was written with answer.csv");
  std::filesystem::remove(fit.path / "config.yaml");
  fit.expect_fault("config.yaml: is missing");
}

TEST(VerifiedDirectory, LooksAtFilesThatHaveNoPlaceForASum) {
  const Written fit("rubfit");
  fit.put("answer.json", "{\"probability\": 0}\r\n");
  EXPECT_TRUE(fit.verdict().faults.empty());  // after a checkout on another system
  fit.put("answer.json", "{\"probability\": 1}\n");
  fit.expect_fault("answer.json: is not as it was written: its sha256 is ");
  std::filesystem::remove(fit.path / "answer.json");
  ASSERT_EQ(::mkfifo((fit.path / "answer.json").c_str(), 0600), 0);
  fit.expect_fault("answer.json: it is not a regular file");
}

TEST(VerifiedDirectory, AFileOfUnknownOriginIsNoDamage) {
  const Written fit("rubfit");
  fit.put("measured.csv", "a;b;b\n1,5;2;3\n");
  fit.put("notes.csv", "");
  fit.put("report.html", "<p>mine</p>");
  fit.put("old.cases", "of wine");
  ASSERT_EQ(::mkfifo((fit.path / "pipe.csv").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((fit.path / "pipe.html").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/full", fit.path / "full.csv");
  std::filesystem::create_directory(fit.path / "folder.csv");
  EXPECT_TRUE(fit.verdict().faults.empty()) << fit.verdict().faults.front();
  EXPECT_EQ(fit.verdict().files.size(), 3u);
  EXPECT_FALSE(was_written_by("ringstab", fit.path));
}

TEST(VerifiedDirectory, ATableThatBecameNoneOrAPipeIsDamaged) {
  const Written fit("rubfit");
  batch::write_result_files({{"answer.csv", "x\n1\n"}, {"other.csv", "y\n2\n"}},
                            std::array<std::string_view, 2>{"answer.csv", "other.csv"}, fit.path,
                            {"rubfit", config::study_digest(SmallMap::config().study)});
  fit.put("other.csv", "");
  fit.expect_fault("other.csv: is not as it was written with answer.csv: is empty");
  std::filesystem::remove(fit.path / "other.csv");
  ASSERT_EQ(::mkfifo((fit.path / "other.csv").c_str(), 0600), 0);
  fit.expect_fault("other.csv: is not as it was written with answer.csv: it is not a regular file");
}

TEST(VerifiedDirectory, WhatIsMadeOfAMapNeedsIt) {
  const SmallMap map;
  map.finish();
  const std::string digest = config::study_digest(SmallMap::config().study);
  batch::write_result_files({{slice_files[0], "x\n1\n"}, {slice_files[1], "y\n2\n"}}, slice_files, map.path,
                            {"rubsweep", digest, {}, {"map.csv"}});
  EXPECT_TRUE(verdict_on(map).faults.empty());
  std::filesystem::remove(map.path / "map.csv");
  expect_fault(map, "map.csv: is missing, the map of attractors.csv");
}

TEST(VerifiedDirectory, APageIsCheckedByItsSumAndItsMap) {
  const SmallMap map;
  map.finish();
  const auto put = [&](const std::string& page) { std::ofstream(map.path / "report.html") << page; };
  const std::string digest = config::study_digest(SmallMap::config().study);
  const std::string page = batch::with_page_sum("<!doctype html>\n<p>" + digest + "</p>\n</html>\n");
  put(page);
  EXPECT_TRUE(verdict_on(map).faults.empty());
  std::string other = page;
  other[page.find("<p>") + 1] = 'q';
  put(other);
  expect_fault(map, "report.html: is not as it was written");
  put(page.substr(0, page.size() - 4));
  expect_fault(map, "report.html: is cut off");
  put(batch::with_page_sum("<!doctype html>\n<p>another digest</p>\n</html>\n"));
  expect_fault(map, "report.html: belongs to another map");
}

/// Tables of a recording, written by two calls, beside a map: they belong to no study.
TEST(VerifiedDirectory, TablesOfARecordingBelongToNoStudy) {
  const SmallMap map;
  map.finish();
  constexpr std::array<std::string_view, 1> names{"turns.csv"};
  batch::write_result_files({{names[0], "x\n1\n"}}, names, map.path, {"rubscope", "of a recording"});
  EXPECT_TRUE(verdict_on(map).faults.empty());
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
}  // namespace rubsweep::apps
