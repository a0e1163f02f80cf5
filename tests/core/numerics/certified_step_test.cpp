#include "rubsweep/core/numerics/certified_step.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rubsweep::numerics {
namespace {

TEST(CertifiedStepSafe, IsTheFirstRootOfTheParabola) {
  for (const double rate : {-3.0, -0.1, 0.0, 0.2, 5.0}) {
    const double t = safe_step(-2, rate, 7);
    EXPECT_NEAR(-2 + rate * t + 3.5 * t * t, 0, 1e-14) << rate;
    EXPECT_GT(t, 0);
    EXPECT_TRUE(stays_below(-2, rate, 7, 0.999 * t));
    EXPECT_FALSE(stays_below(-2, rate, 7, 1.001 * t));
  }
  EXPECT_EQ(safe_step(0, 1, 7), 0);
  EXPECT_TRUE(std::isinf(safe_step(-1, -1, 0)));
  EXPECT_FALSE(stays_below(0, -1, 1, 0.1));  // zero is not below
}

/// cos t - c with |g''| <= 1, from many instants: no safe step passes a zero, including a grazing one (c =
/// 1).
TEST(CertifiedStepSafe, NeverPassesAZero) {
  for (const double c : {0.2, 0.9, 1.0, 1.0 + 1e-9}) {
    for (double t = 1.7; t < 6; t += 0.01) {
      const double value = std::cos(t) - c;
      if (value >= 0) continue;
      const double step = safe_step(value, -std::sin(t), 1);
      for (int i = 0; i <= 50; ++i) EXPECT_LE(std::cos(t + step * i / 50) - c, 1e-15) << c << ' ' << t;
    }
  }
}

/// Where a crossing is certain, the zero lies between the safe step and the latest crossing, and the function
/// rises there throughout.
TEST(CertifiedStepCrosses, TheZeroLiesBetweenItsBounds) {
  int certain = 0;
  for (double t = 3.2; t < 6; t += 0.01) {
    const double c = 0.4, zero = 2 * std::numbers::pi - std::acos(c);
    const double value = std::cos(t) - c, rate = -std::sin(t);
    if (value >= 0 || !crosses(value, rate, 1)) continue;
    ++certain;
    const double latest = latest_crossing(value, rate, 1);
    EXPECT_LE(safe_step(value, rate, 1), zero - t + 1e-14);
    EXPECT_GE(latest, zero - t - 1e-14);
    EXPECT_GT(-std::sin(t + latest), 0);
  }
  EXPECT_GT(certain, 20);
  EXPECT_FALSE(crosses(-1, 0, 1));
  EXPECT_FALSE(crosses(-1e-3, -1, 1));
  EXPECT_TRUE(crosses(0, 1, 1));
}

TEST(CertifiedStepRootOfSeries, FindsTheZeroOfASine) {
  for (const double start : {-0.7, -0.1, -1e-9, 0.2}) {
    std::array<double, 19> terms{};  // terms of sin(start + x)
    double factorial = 1;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (k > 0) factorial *= static_cast<double>(k);
      terms[k] = std::sin(start + static_cast<double>(k) * std::numbers::pi / 2) / factorial;
    }
    EXPECT_NEAR(root_of_series(terms), -start, 2e-16 + 1e-15 * std::abs(start)) << start;
  }
}

TEST(CertifiedStepNextRoot, IsExactForParabolas) {
  const double root = next_root(-0.5, 2, 3);
  EXPECT_NEAR(-0.5 + 2 * root + 1.5 * root * root, 0, 1e-15);
  EXPECT_NEAR(next_root(-1, 2, -100), 0.5, 1e-15);  // without a root the Newton step is taken
}

}  // namespace
}  // namespace rubsweep::numerics
