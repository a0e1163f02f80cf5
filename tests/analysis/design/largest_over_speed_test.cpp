#include "rubsweep/analysis/design/largest_over_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/design/amplification.hpp"

namespace rubsweep::design {
namespace {

/// Quiet whirl of a Jeffcott rotor of 50 Hz: largest at 1 / sqrt(1 - 2 zeta^2), 1 / (2 zeta sqrt(1 -
/// zeta^2)).
TEST(LargestOverSpeed, FindsAResonanceAThousandTimesNarrowerThanTheSteps) {
  for (const double zeta : {0.1, 1e-3, 1e-6}) {
    const SpeedRange range{1, 173};
    const linear::CriticalSpeed critical{1, 50 * std::sqrt(1 - zeta * zeta), zeta, 1};
    const auto speeds = response_speeds(range, std::vector{critical});
    EXPECT_TRUE(std::ranges::is_sorted(speeds));
    EXPECT_EQ(speeds.front(), 1);
    EXPECT_EQ(speeds.back(), 173);
    const Largest found = largest_over_speed(speeds, [&](double hz) { return amplification(hz / 50, zeta); });
    EXPECT_NEAR(found.speed_hz, 50 / std::sqrt(1 - 2 * zeta * zeta), 1e-5 * (1 + zeta)) << zeta;
    const double expected = 1 / (2 * zeta * std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(found.value, expected, 1e-9 * expected) << zeta;
  }
}

TEST(LargestOverSpeed, IsAtAnEndWhereThereIsNoPeak) {
  const std::vector<double> speeds{1, 2, 3};
  EXPECT_EQ(largest_over_speed(speeds, [](double hz) { return hz; }).speed_hz, 3);
  EXPECT_EQ(largest_over_speed(speeds, [](double hz) { return -hz; }).speed_hz, 1);
}

TEST(LargestOverSpeed, WhatIsNotFiniteIsInfinite) {
  const std::vector<double> speeds{1, 2, 3};
  const Largest found = largest_over_speed(
      speeds, [](double hz) { return hz == 2 ? std::numeric_limits<double>::quiet_NaN() : 1e300; });
  EXPECT_EQ(found.speed_hz, 2);
  EXPECT_TRUE(std::isinf(found.value));
}

}  // namespace
}  // namespace rubsweep::design
