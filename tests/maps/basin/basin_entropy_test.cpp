#include "rubsweep/maps/basin/basin_entropy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::basin {
namespace {

TEST(BasinEntropy, OfHalvesAndWholes) {
  // Two boxes of 2 x 2: one with a single label, one with two labels in equal parts; the fifth column belongs
  // to no box.
  const LabelGrid grid{5, 2, {1, 1, 1, 2, 7, 1, 1, 2, 1, 7}};
  const BasinEntropy entropy = basin_entropy(grid, 2);
  EXPECT_NEAR(entropy.all, std::log(2) / 2, 1e-15);
  EXPECT_NEAR(entropy.boundary, std::log(2), 1e-15);
}

TEST(BasinEntropy, OfOneLabelIsNone) {
  const BasinEntropy entropy = basin_entropy({4, 4, std::vector<int>(16, 3)}, 2);
  EXPECT_EQ(entropy.all, 0);
  EXPECT_EQ(entropy.boundary, 0);
}

template <class Label>
LabelGrid grid_of(std::size_t side, const Label& label) {
  LabelGrid grid{side, side, {}};
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) grid.labels.push_back(label(i, j));
  }
  return grid;
}

TEST(BasinEntropy, OfALineIsOne) {
  const auto exponent = uncertainty_exponent(
      grid_of(513, [](std::size_t i, std::size_t j) { return 3 * i + j < 900 ? 0 : 1; }));
  ASSERT_TRUE(exponent);
  EXPECT_NEAR(exponent->value, 1, 0.03);
  EXPECT_LT(exponent->standard_error, 0.02);
}

/// Stripes whose edges form the Cantor set without middle halves: the boundary has the dimension 1 + 1/2.
TEST(BasinEntropy, OfACantorSetIsItsCodimension) {
  const auto removed_at = [](std::size_t i) {
    for (std::size_t level = 0, digit_place = 1024; level < 6; ++level, digit_place /= 4) {
      const std::size_t digit = i / digit_place % 4;
      if (digit == 1 || digit == 2) return static_cast<int>(level % 2);
    }
    return 2;
  };
  const auto exponent =
      uncertainty_exponent(grid_of(2049, [&](std::size_t i, std::size_t) { return removed_at(2 * i); }));
  ASSERT_TRUE(exponent);
  EXPECT_NEAR(exponent->value, 0.5, 0.05);
}

TEST(BasinEntropy, IsEmptyWithoutABoundary) {
  EXPECT_FALSE(uncertainty_exponent(grid_of(65, [](std::size_t, std::size_t) { return 4; })));
}

}  // namespace
}  // namespace rubsweep::basin
