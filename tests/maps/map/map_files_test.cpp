#include "rubsweep/maps/map/map_files.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rubsweep::map {
namespace {

TEST(MapFilesShare, TheNamesOfPartsTellHowManyThereAre) {
  EXPECT_EQ(share_name(std::nullopt), "map");
  EXPECT_EQ(share_name(Share{0, 3}), "map.shard-1-of-3");
  EXPECT_EQ(share_name(Share{11, 12}), "map.shard-12-of-12");
  EXPECT_EQ(share_count_of("map.shard-1-of-3"), 3u);
  EXPECT_EQ(share_count_of("map.shard-12-of-12.journal"), 12u);
  for (const char* other :
       {"map", "map.journal", "map.rank-1-of-3.journal", "map.shard-1.journal", "map.shard-1-of-x"})
    EXPECT_EQ(share_count_of(other), 0u) << other;
}

TEST(MapFilesShare, CellsOfAWholeMapAreDealtOutInTurn) {
  for (std::size_t cell = 0; cell < 12; ++cell) EXPECT_EQ(share_of(cell, 5, false), cell % 5);
}

TEST(MapFilesShare, CellsOfALatticeAreSpreadOverAllShares) {
  // Every eighth cell: a division with remainder would give all of them to one of eight shares.
  constexpr std::size_t shares = 8, cells = 8000;
  std::vector<std::size_t> counts(shares);
  for (std::size_t i = 0; i < cells; ++i) ++counts[share_of(8 * i, shares, true)];
  // Standard deviation of a random distribution: sqrt(8000 * 1/8 * 7/8), about 30.
  for (const std::size_t count : counts) EXPECT_NEAR(static_cast<double>(count), 1000, 150);
}

}  // namespace
}  // namespace rubsweep::map
