#include "rubsweep/core/numerics/straight_line.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rubsweep::numerics {
namespace {

TEST(StraightLine, ThroughPointsOnALineIsThatLine) {
  const std::vector<double> x{-1, 0.5, 2, 7}, y{5, 2, -1, -11};
  const StraightLine line = line_through(x, y);
  EXPECT_DOUBLE_EQ(line.slope, -2);
  EXPECT_DOUBLE_EQ(line(0), 3);
  EXPECT_NEAR(largest_distance(line, x, y), 0, 1e-14);
}

TEST(StraightLine, HasTheLeastSquares) {
  const std::vector<double> x{0, 1, 2, 3}, y{0, 2, 1, 3};
  const StraightLine line = line_through(x, y);
  // By hand: the means are 1.5, products add up to 4 and squares to 5.
  EXPECT_DOUBLE_EQ(line.slope, 0.8);
  EXPECT_NEAR(line(0), 0.3, 1e-15);
  EXPECT_NEAR(largest_distance(line, x, y), 0.9, 1e-15);
}

}  // namespace
}  // namespace rubsweep::numerics
