#include "rubsweep/basin/basin_entropy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::basin {
namespace {

TEST(BasinEntropy, OfHalvesAndWholes) {
  // Two boxes of 2 x 2: one of a single label, one half and half; the fifth column is no box.
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

}  // namespace
}  // namespace rubsweep::basin
