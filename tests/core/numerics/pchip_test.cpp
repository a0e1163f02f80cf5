#include "rubsweep/core/numerics/pchip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/interpolators/pchip.hpp>
#include <cmath>
#include <utility>
#include <vector>

namespace rubsweep::numerics {
namespace {

std::vector<double> spaced(double from, double to, int pieces) {
  std::vector<double> x;
  for (int i = 0; i <= pieces; ++i) x.push_back(from + (to - from) * i / pieces);
  return x;
}

/// Data set RPN 14 of Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980), with values printed in NAG's
/// manual for the routines e01bec / e01bfc.
TEST(Pchip, MeetsPublishedValues) {
  const Pchip curve({7.99, 8.09, 8.19, 8.7, 9.2, 10, 12, 15, 20},
                    {0, 0.27643e-4, 0.4375e-1, 0.16918, 0.46943, 0.94374, 0.99864, 0.99992, 0.99999});
  const double expected[]{0, 0.4640, 0.9645, 0.9965, 0.9992, 0.9998, 0.9999, 1, 1, 1, 1};
  for (int i = 0; i <= 10; ++i) EXPECT_NEAR(curve(7.99 + 1.201 * i), expected[i], 5e-5 + 1e-9) << i;
}

TEST(Pchip, HasTheExactValuesAtItsPoints) {
  const std::vector<double> x{0.1, 0.30000000000000004, 1.7, 2, 11},
      y{1 / 3.0, 1e9 / 7, -2.2, -2.2, 1e-7 / 3};
  const Pchip curve(x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(curve(x[i]), y[i]) << i;
}

TEST(Pchip, IsThatOfBoostBetweenInnerPoints) {
  const std::vector<double> x{0, 0.7, 1, 2.5, 3, 4.2, 5}, y{1, 2, 2.1, 7, 6, 6, 9};
  const Pchip curve(x, y);
  std::vector<double> its_x = x, its_y = y;
  const boost::math::interpolators::pchip<std::vector<double>> other(std::move(its_x), std::move(its_y));
  for (double at = 0.7; at < 4.2; at += 0.01) {
    EXPECT_NEAR(curve(at), other(at), 1e-13) << at;
    EXPECT_NEAR(curve.slope(at), other.prime(at), 1e-12) << at;
  }
}

TEST(Pchip, NeverOvershootsAndStaysMonotone) {
  const std::vector<double> x{0, 1, 1.1, 2, 4, 5, 9}, y{0, 0, 5, 5.01, 9, 9, -3};
  const Pchip curve(x, y);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    double before = y[i];
    for (int k = 1; k <= 200; ++k) {
      const double value = curve(x[i] + (x[i + 1] - x[i]) * k / 200);
      EXPECT_GE((value - before) * (y[i + 1] - y[i]), -1e-14) << i << " " << k;
      before = value;
    }
  }
}

TEST(Pchip, DerivativeIsContinuousAndThatOfTheCurve) {
  const std::vector<double> x{0, 0.7, 1, 2.5, 3, 4.2, 5}, y{1, 2, 2.1, 7, 6, 6, 9};
  const Pchip curve(x, y);
  for (const double at : x) EXPECT_NEAR(curve.slope(at - 1e-9), curve.slope(at + 1e-9), 1e-6) << at;
  for (const double at : spaced(0.05, 4.95, 37))
    EXPECT_NEAR(curve.slope(at), (curve(at + 1e-6) - curve(at - 1e-6)) / 2e-6, 1e-7) << at;
}

TEST(Pchip, StraightLinesAreExactAndACubicIsMetFasterThanItsPointsGrow) {
  const Pchip line({0, 1, 5, 6}, {1, 3, 11, 13});
  for (const double at : spaced(0, 6, 60)) EXPECT_NEAR(line(at), 1 + 2 * at, 1e-14);
  const auto error = [](int pieces) {
    const std::vector<double> x = spaced(1, 2, pieces);
    std::vector<double> y;
    for (const double at : x) y.push_back(at * at * at);
    const Pchip curve(x, y);
    double largest = 0;
    for (const double at : spaced(1, 2, 1000))
      largest = std::max(largest, std::abs(curve(at) - at * at * at));
    return largest;
  };
  EXPECT_LT(error(20), 2e-4);
  EXPECT_LT(error(40), error(20) / 6) << "third order at least";
}

TEST(Pchip, FewPoints) {
  const Pchip one({3}, {7}), two({0, 2}, {1, 5}), three({0, 1, 2}, {0, 1, 4});
  EXPECT_EQ(one(-1), 7);
  EXPECT_EQ(one.slope(3), 0);
  EXPECT_DOUBLE_EQ(two(0.5), 2);
  EXPECT_DOUBLE_EQ(two.slope(1), 2);
  // Slopes by hand: 0 at the left end, where the three-point formula gives (3 * 1 - 3) / 2, and 1.5 in the
  // middle.
  EXPECT_DOUBLE_EQ(three.slope(0), 0);
  EXPECT_DOUBLE_EQ(three.slope(1), 1.5);
  EXPECT_DOUBLE_EQ(three.slope(2), 4);
}

TEST(Pchip, BeyondTheEndsIsTheEnd) {
  const Pchip curve({1, 2, 3, 4}, {1, 4, 9, 16});
  EXPECT_EQ(curve(0.5), 1);
  EXPECT_EQ(curve(7), 16);
}

}  // namespace
}  // namespace rubsweep::numerics
