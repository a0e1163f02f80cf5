#include "rubsweep/maps/map/missing_cells.hpp"

#include <gtest/gtest.h>

#include "maps/map/small_map.hpp"

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

}  // namespace
}  // namespace rubsweep::map
