#include "rubsweep/analysis/branch/continuation/dip.hpp"

#include <gtest/gtest.h>

namespace rubsweep::branch::continuation {
namespace {

/// a (s - r) (s - q) on a step of this length.
std::optional<double> dip_of_parabola(double a, double r, double q, double length) {
  const auto value = [&](double s) { return a * (s - r) * (s - q); };
  const auto slope = [&](double s) { return a * (2 * s - r - q); };
  return dip_of_cubic({value(0), value(length), slope(0), slope(length)}, length);
}

/// The lowest point is in the middle of the roots, whatever the sign of the function.
TEST(Dip, BetweenTwoRoots) {
  for (const double a : {3.0, -0.2}) {
    const auto share = dip_of_parabola(a, 0.1, 0.3, 0.5);
    ASSERT_TRUE(share);
    EXPECT_NEAR(*share, 0.2 / 0.5, 1e-14);
    EXPECT_TRUE(dip_of_parabola(a, 0.499, 0.4995, 0.5)) << "at the very end";
  }
}

TEST(Dip, NoneWhereOneRootOrNoneIsInside) {
  EXPECT_FALSE(dip_of_parabola(1, 0.2, 0.7, 0.5));
  EXPECT_FALSE(dip_of_parabola(1, -0.2, -0.1, 0.5));
  EXPECT_FALSE(dip_of_parabola(1, 0.6, 0.9, 0.5));
}

/// (s - 1/2)^2 + c between 0 and 1: what comes near to zero is to be looked at, what stays away is not.
TEST(Dip, NearlyARoot) {
  const auto above = [](double c) { return dip_of_cubic({0.25 + c, 0.25 + c, -1, 1}, 1); };
  EXPECT_TRUE(above(0.01));
  EXPECT_FALSE(above(0.3));
}

/// (s - 0.2) (s - 0.5) (s - 0.9): the signs at the ends tell one root, and there are two more.
TEST(Dip, ThreeRoots) {
  const auto value = [](double s) { return (s - 0.2) * (s - 0.5) * (s - 0.9); };
  const auto slope = [](double s) { return 3 * s * s - 3.2 * s + 0.73; };
  const auto share = dip_of_cubic({value(0), value(1), slope(0), slope(1)}, 1);
  ASSERT_TRUE(share);
  EXPECT_NEAR(slope(*share), 0, 1e-14);
  EXPECT_GT(value(*share), 0) << "the first extremum";
  // One root, with a turn before it that keeps its distance: s^3 - s + 1 on -1.5 <= s <= 0.
  EXPECT_FALSE(dip_of_cubic({-0.875, 1, 5.75, -1}, 1.5));
}

/// The mean of (s - 0.3) (s - 0.6) over 0 <= s <= 1.
TEST(Dip, OfAQuadraticByItsMean) {
  const auto share = dip_of_quadratic(0.18, 0.28, 1.0 / 3 - 0.45 + 0.18);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 0.45, 1e-14);
  EXPECT_FALSE(dip_of_quadratic(1, 2, 1.5)) << "a straight line";
}

}  // namespace
}  // namespace rubsweep::branch::continuation
