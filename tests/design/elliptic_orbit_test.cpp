#include "rubsweep/design/elliptic_orbit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::design {
namespace {

using namespace std::complex_literals;
using Complex = std::complex<double>;

/// Largest distance from the middle over a turn, doubled.
double traced_axis(const Eigen::Vector2cd& amplitude) {
  double farthest = 0;
  for (int k = 0; k < 20000; ++k) {
    const Complex turned = std::polar(1.0, 2 * std::numbers::pi * k / 20000);
    farthest = std::max(farthest, std::hypot((amplitude(0) * turned).real(), (amplitude(1) * turned).real()));
  }
  return 2 * farthest;
}

TEST(EllipticOrbit, AxisOfACircleIsItsDiameter) {
  EXPECT_DOUBLE_EQ(major_axis({3.0, -3.0i}), 6);
  EXPECT_DOUBLE_EQ(major_axis({3.0, 3.0i}), 6) << "backward";
}

/// Neither the peak to peak of x, 2, nor that of y is the axis.
TEST(EllipticOrbit, AxisOfALeaningLineIsLongerThanItsShadows) {
  EXPECT_NEAR(major_axis({1.0, 1.0}), 2 * std::sqrt(2), 1e-15);
  EXPECT_NEAR(major_axis({3.0i, 4.0i}), 10, 1e-14);
}

TEST(EllipticOrbit, AxisIsThatOfTheTracedOrbit) {
  for (const Complex y : {Complex(0.2, 0.9), Complex(-1.4, 0.3), Complex(0.05, -0.6), Complex(0, 0)}) {
    const Eigen::Vector2cd amplitude(Complex(0.7, -0.4), y);
    EXPECT_NEAR(major_axis(amplitude), traced_axis(amplitude), 1e-6) << y;
  }
}

}  // namespace
}  // namespace rubsweep::design
