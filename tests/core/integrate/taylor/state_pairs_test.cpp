#include "rubsweep/core/integrate/taylor/state_pairs.hpp"

#include <gtest/gtest.h>

namespace rubsweep::integrate::taylor {
namespace {

TEST(StatePairs, HoldCoordinatesTwoByTwo) {
  Eigen::Matrix<double, 6, 1> vector;
  vector << 1, 2, 3, 4, 5, 6;
  StatePairs<6> pairs(vector);
  static_assert(StatePairs<6>::count == 3);
  for (std::size_t h = 0; h < 3; ++h) {
    EXPECT_EQ(pairs[h][0], vector(static_cast<Eigen::Index>(2 * h)));
    EXPECT_EQ(pairs[h][1], vector(static_cast<Eigen::Index>(2 * h + 1)));
  }
  pairs[1] = numerics::Twin{7, 8};
  EXPECT_EQ(pairs[1][1], 8);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
