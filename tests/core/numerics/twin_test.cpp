#include "rubsweep/core/numerics/twin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace rubsweep::numerics {
namespace {

TEST(Twin, ItsPartsAreWhereTheyAreLookedFor) {
  const Twin pair{3, -5};
  EXPECT_EQ(swapped(pair)[0], -5);
  EXPECT_EQ(swapped(pair)[1], 3);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(both(7)[i], 7);
    EXPECT_EQ(first_twice(pair)[i], 3);
    EXPECT_EQ(second_twice(pair)[i], -5);
  }
  EXPECT_EQ(larger(pair, Twin{1, -2})[0], 3);
  EXPECT_EQ(larger(pair, Twin{1, -2})[1], -2);
  EXPECT_EQ(smaller(pair, Twin{1, -2})[0], 1);
  EXPECT_EQ(smaller(pair, Twin{1, -2})[1], -5);
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
  EXPECT_EQ(load(stored.data())[0], 3);
  EXPECT_EQ(load(stored.data())[1], -5);
}

}  // namespace
}  // namespace rubsweep::numerics
