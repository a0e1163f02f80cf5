#include "rubsweep/numerics/twin.hpp"

#include <gtest/gtest.h>

#include <array>

namespace rubsweep::numerics {
namespace {

TEST(Twin, ItsPartsAreWhereTheyAreLookedFor) {
  const Twin pair{3, -5};
  EXPECT_EQ(swapped(pair)[0], -5);
  EXPECT_EQ(swapped(pair)[1], 3);
  EXPECT_EQ(first_twice(pair)[1], 3);
  EXPECT_EQ(second_twice(pair)[0], -5);
  EXPECT_EQ(sum_of(pair)[0], -2);
  EXPECT_EQ(sum_of(pair)[1], -2);
  EXPECT_EQ(sums_of(pair, Twin{10, 20})[0], -2);
  EXPECT_EQ(sums_of(pair, Twin{10, 20})[1], 30);
  EXPECT_EQ(magnitudes(pair)[0], 3);
  EXPECT_EQ(magnitudes(pair)[1], 5);
  // i (3 - 5 i) = 5 + 3 i.
  EXPECT_EQ(quarter_turned(pair)[0], 5);
  EXPECT_EQ(quarter_turned(pair)[1], 3);
  std::array<double, 2> stored{};
  store(stored.data(), pair);
  EXPECT_EQ(stored, (std::array<double, 2>{3, -5}));
}

}  // namespace
}  // namespace rubsweep::numerics
