#include "rubsweep/maps/map/compute_map.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "maps/batch/read_whole_file.hpp"
#include "maps/map/small_map.hpp"

namespace rubsweep::map {
namespace {

TEST(ComputeMap, TheWholeMapStandsInTheDirectory) {
  const SmallMap map;
  const auto summary = compute(SmallMap::config(), map.path);
  ASSERT_TRUE(summary);
  EXPECT_FALSE(summary->has_failed_cells());
  const MapDirectory there = map.begin();
  ASSERT_TRUE(there.finished_map());
  EXPECT_EQ(there.finished_map()->cells, 4u);
}

TEST(ComputeMap, AFinishedMapIsLeftAsItIs) {
  const SmallMap map;
  const auto first = compute(SmallMap::config(), map.path);
  const std::string text = batch::read_whole_file(map.path / "map.csv");
  const auto second = compute(SmallMap::config(), map.path);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->text(), second->text());
  EXPECT_EQ(batch::read_whole_file(map.path / "map.csv"), text);
}

TEST(ComputeMap, WhatWasStoppedIsContinuedToTheSameBytes) {
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
