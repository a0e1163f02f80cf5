#include "rubsweep/maps/map/missing_cells.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::map {
namespace {

TEST(MissingCells, ARefinedMapSaysWhatItCost) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config(SmallMap::refined());
  MapDirectory directory(map.path, config, std::nullopt, false, "rubtest");
  MissingCells missing({}, config.study, directory);
  ASSERT_TRUE(missing.run());
  EXPECT_EQ(missing.left_to_others(), 0u);
  EXPECT_NE(missing.description().find("of 25 cells"), std::string::npos) << missing.description();
}

TEST(MissingCells, CellsThatRunWhenTheWorkIsGivenUpAreNotWrittenDown) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config();
  MapDirectory directory = map.begin();
  MissingCells missing({.threads = 1, .program = "rubtest"}, config.study, directory);
  ASSERT_TRUE(missing.give_up());
  EXPECT_FALSE(missing.run());
  EXPECT_EQ(missing.interrupted(),
            "rubtest: interrupted; 0 of 4 cells are finished, the same command computes the others\n");
  EXPECT_EQ(map.begin().missing().size(), 4u);
}

TEST(MissingCells, NothingIsGivenUpOnceEveryCellIsFinished) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config();
  MapDirectory directory = map.begin();
  MissingCells missing({}, config.study, directory);
  ASSERT_TRUE(missing.run());
  EXPECT_FALSE(missing.give_up());
}

TEST(MissingCells, AMachineThatIsPreparedAlreadyIsNotPreparedAgain) {
  const SmallMap map;
  const config::RunConfig config = SmallMap::config();
  MapDirectory directory = map.begin();
  // The rows show by the damping ratio which of the two machines was used.
  model::Machine other = config.study.machine;
  std::get<model::JeffcottRotor>(other.rotor).damping_ratio = 0.3;
  MissingCells missing({.prepared = scene::prepare_machine(other)}, config.study, directory);
  ASSERT_TRUE(missing.run());
  directory.write_map();
  const SmallMap damped;
  ASSERT_TRUE(compute(SmallMap::config({"rotor.damping_ratio=0.3"}), damped.path));
  const auto rows = [](const SmallMap& of) {
    const std::string table = batch::read_whole_file(of.path / "map.csv");
    return table.substr(table.find("\nspeed_hz"));
  };
  EXPECT_EQ(rows(map), rows(damped));
}

TEST(MissingCellsCellLog, ACellIsInTheJournalAndInThePartialMapAtOnce) {
  const SmallMap map;
  MapDirectory directory = map.begin();
  CellLog log(directory, batch::ProgressMode::never);
  log.add(3, SmallMap::line(3));
  EXPECT_EQ(log.finished(), 1u);
  EXPECT_TRUE(batch::read_whole_file(directory.partial()).ends_with('\n' + SmallMap::line(3) + '\n'));
  directory.leave();
  EXPECT_EQ(map.begin().missing(), (std::vector<std::size_t>{0, 1, 2}));
}

TEST(MissingCellsCellLog, ACellOfAnotherProcessIsShownAndStaysInItsOwnJournal) {
  const SmallMap map;
  MapDirectory directory = map.begin();
  {
    CellLog log(directory, batch::ProgressMode::never);
    log.add_of_other_process(3, SmallMap::line(3));
    EXPECT_EQ(log.finished(), 1u);
    EXPECT_TRUE(batch::read_whole_file(directory.partial()).ends_with('\n' + SmallMap::line(3) + '\n'));
  }
  directory.leave();
  EXPECT_EQ(map.begin().missing().size(), 4u);
}

TEST(MissingCellsCellLog, TheMessageAfterASignalCountsWhatEarlierRunsFinished) {
  const SmallMap map;
  map.begin().journal().append(1, SmallMap::line(1));
  const MapDirectory directory = map.begin();
  EXPECT_EQ(interrupted_map("rubtest", directory, 2),
            "rubtest: interrupted; 3 of 4 cells are finished, the same command computes the others\n");
}

TEST(MissingCellsComputeMap, TheWholeMapStandsInTheDirectory) {
  const SmallMap map;
  const auto summary = compute(SmallMap::config(), map.path);
  ASSERT_TRUE(summary);
  EXPECT_FALSE(summary->has_failed_cells());
  const MapDirectory there = map.begin();
  ASSERT_TRUE(there.finished_map());
  EXPECT_EQ(there.finished_map()->cells, 4u);
}

TEST(MissingCellsComputeMap, AFinishedMapIsLeftAsItIs) {
  const SmallMap map;
  const auto first = compute(SmallMap::config(), map.path);
  const std::string text = batch::read_whole_file(map.path / "map.csv");
  const auto second = compute(SmallMap::config(), map.path);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->text(), second->text());
  EXPECT_EQ(batch::read_whole_file(map.path / "map.csv"), text);
}

TEST(MissingCellsComputeMap, WhatWasStoppedIsContinuedToTheSameBytes) {
  const SmallMap map, at_once;
  ASSERT_TRUE(compute(SmallMap::config(), at_once.path));
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(compute(SmallMap::config(), map.path, {.stop = &stop}));
  EXPECT_FALSE(std::filesystem::exists(map.path / "map.csv"));
  map.begin().journal().append(2, [&] {
    std::string line;
    std::ifstream rows(at_once.path / "map.csv");
    for (int row = -1; row < 3 && std::getline(rows, line);) row += line.empty() || line[0] != '#';
    return line;
  }());
  ASSERT_TRUE(compute(SmallMap::config(), map.path, {.threads = 1}));
  EXPECT_EQ(batch::read_whole_file(map.path / "map.csv"), batch::read_whole_file(at_once.path / "map.csv"));
}

}  // namespace
}  // namespace rubsweep::map
