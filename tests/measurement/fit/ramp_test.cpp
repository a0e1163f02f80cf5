#include "rubsweep/measurement/fit/ramp.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rubsweep::fit {
namespace {

using std::numbers::pi;

const Ramp even{.from_hz = 10, .rate_hz_per_s = 2};
const Ramp uneven{.from_hz = 0, .rate_hz_per_s = 0, .knot_s = {0, 1, 3}, .knot_hz = {10, 14, 12}};

TEST(Ramp, GoesOnBeyondItsKnots) {
  EXPECT_DOUBLE_EQ(speed_hz(even, 3), 16);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, 0.5), 12);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, 2), 13);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, -1), 6);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, 4), 11);
}

TEST(RampTurning, HasTheIntegralOfTheSpeedForItsAngle) {
  for (const Ramp& ramp : {even, uneven}) {
    const RampTurning turning(ramp);
    double angle = 0;
    constexpr int steps = 3000;
    for (int k = 0; k < steps; ++k) angle += turning.speed((k + 0.5) * 3.0 / steps) * 3.0 / steps;
    EXPECT_NEAR(turning.angle(3) - turning.angle(0), angle, 1e-9 * angle);
  }
}

TEST(RampTurning, KnowsItsRatesAndTheSpeedsBetween) {
  const RampTurning turning(uneven);
  EXPECT_DOUBLE_EQ(turning.gain(0.5), 2 * pi * 4);
  EXPECT_DOUBLE_EQ(turning.gain(2), -2 * pi);
  EXPECT_DOUBLE_EQ(turning.most_gain(), 2 * pi * 4);
  const auto [low, high] = turning.speeds_between(0.5, 3);
  EXPECT_DOUBLE_EQ(low, 2 * pi * 12);
  EXPECT_DOUBLE_EQ(high, 2 * pi * 14);
}

}  // namespace
}  // namespace rubsweep::fit
