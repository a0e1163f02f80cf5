#include "rubsweep/core/scene/two_orders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace rubsweep::scene {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

TEST(TwoOrders, OneOrderHasItsAmplitude) {
  const TopOfMotion first = largest_value(std::polar(3.0, 0.7), 0);
  EXPECT_NEAR(first.value, 3, 1e-15);
  EXPECT_NEAR(first.phase_rad, 2 * pi - 0.7, 1e-14);
  const TopOfMotion second = largest_value(0, std::polar(2.0, -1.0));
  EXPECT_NEAR(second.value, 2, 1e-15);
  EXPECT_NEAR(second.phase_rad, 0.5, 1e-14);  // the first of two maxima
  EXPECT_EQ(largest_value(0, 0).value, 0);
}

/// cos x + a cos 2x with a > 1/4 has the minimum -a - 1/(8a) at cos x = -1/(4a).
TEST(TwoOrders, TheLeastValueOfTwoCosinesIsKnown) {
  for (const double a : {0.3, 0.5, 2.0}) {
    const TopOfMotion top = largest_value(-1, -a);
    EXPECT_NEAR(top.value, a + 1 / (8 * a), 1e-14);
    EXPECT_NEAR(std::cos(top.phase_rad), -1 / (4 * a), 1e-13);
  }
}

/// Forward circles at 1X and 2X: |r1 e^{i x} + r2 e^{2 i x + i d}| = r1 + r2 where both vectors are parallel.
TEST(TwoOrders, TwoCirclesReachTheSumOfTheirRadii) {
  const double r1 = 0.8, r2 = 0.5, d = 1.1;
  const Complex i(0, 1), turned = std::polar(r2, d);
  const TopOfMotion top = largest_distance({r1, -i * r1}, {turned, -i * turned});
  EXPECT_NEAR(top.value, r1 + r2, 1e-14);
  EXPECT_NEAR(std::cos(top.phase_rad + d), 1, 1e-14);
}

/// No value on a fine grid exceeds the maximum, and the maximum is reached.
TEST(TwoOrders, NothingIsAboveTheTop) {
  for (int seed = 0; seed < 40; ++seed) {
    const auto number = [&](int k) { return std::polar(1 + std::sin(seed + 3.0 * k), 1.7 * seed * k + k); };
    const Eigen::Vector2cd first(number(1), number(2)), second(number(3), number(4));
    const auto place = [&](double x) {
      return Eigen::Vector2d((first * std::polar(1.0, x) + second * std::polar(1.0, 2 * x)).real());
    };
    double far = 0, high = -1e9;
    for (int k = 0; k < 20000; ++k) {
      const Eigen::Vector2d z = place(2 * pi * k / 20000);
      far = std::max(far, z.norm());
      high = std::max(high, z.x());
    }
    const TopOfMotion farthest = largest_distance(first, second),
                      highest = largest_value(first(0), second(0));
    EXPECT_LE(far, farthest.value * (1 + 1e-14));
    EXPECT_NEAR(far, farthest.value, 1e-6 * far);
    EXPECT_NEAR(place(farthest.phase_rad).norm(), farthest.value, 1e-13 * far);
    EXPECT_LE(high, highest.value + 1e-13);
    EXPECT_NEAR(place(highest.phase_rad).x(), highest.value, 1e-13);
  }
}

TEST(TwoOrders, NumbersThatAreNotFiniteReachEverywhere) {
  const double none = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(largest_value(none, 1).value, inf);
  EXPECT_EQ(largest_distance({1, inf}, {0, 1}).value, inf);
}

}  // namespace
}  // namespace rubsweep::scene
