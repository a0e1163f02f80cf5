#include "rubsweep/ramp/speed_ramp.hpp"

#include <gtest/gtest.h>

namespace rubsweep::ramp {
namespace {

TEST(SpeedRamp, AngleIsQuadraticAndTimeItsInverse) {
  for (const SpeedRamp& ramp : {SpeedRamp{10, 60, 2, 0}, SpeedRamp{60, 10, -2, 0}}) {
    EXPECT_DOUBLE_EQ(ramp.duration_s(), 25);
    EXPECT_DOUBLE_EQ(ramp.speed_hz(25), ramp.to_hz);
    // The mean speed over the whole ramp.
    EXPECT_NEAR(ramp.angle_rad(25), 2 * std::numbers::pi * 35 * 25, 1e-9);
    for (const double t_s : {0.0, 0.3, 11.0, 24.9})
      EXPECT_NEAR(ramp.time_s(ramp.angle_rad(t_s) / (2 * std::numbers::pi)), t_s, 1e-11);
  }
}

}  // namespace
}  // namespace rubsweep::ramp
