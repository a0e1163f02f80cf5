#include "rubsweep/core/model/rolling_bearing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::model {
namespace {

/// Deep groove ball bearing 6205-2RS: multiples of the running speed as published by the bearing data centre
/// of Case Western Reserve University.
TEST(RollingBearing, StrikesAsOftenAsThePublishedBearing) {
  const RollingBearing bearing{
      .pitch_diameter_m = 1.537 * 0.0254, .ball_diameter_m = 0.3126 * 0.0254, .balls = 9};
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::inner_race), 5.4152, 1e-4);
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::outer_race), 3.5848, 1e-4);
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::cage), 0.39828, 1e-4);
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::ball), 4.7135, 1e-4);
}

/// Speeds without slip: the centre of a ball moves at the mean speed of both races, and the ball spins by
/// their difference.
TEST(RollingBearing, RollsWithoutSlip) {
  const RollingBearing bearing{
      .pitch_diameter_m = 0.06, .ball_diameter_m = 0.01, .balls = 12, .contact_angle_deg = 25};
  const double tilted = 0.01 * std::cos(25 * 3.14159265358979323846 / 180);
  const double inner_surface = (0.06 - tilted) / 2;  // speed of the inner race where it touches, at 1 rad/s
  const double cage = inner_surface / 2 / (0.06 / 2);
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::cage), cage, 1e-15);
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::outer_race), 12 * cage, 1e-14);
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::inner_race), 12 * (1 - cage), 1e-14);
  // Relative to the cage the outer race moves backwards, and the ball rolls on it.
  const double spin = cage * (0.06 + tilted) / 0.01;
  EXPECT_NEAR(strikes_per_revolution(bearing, BearingDefect::ball), 2 * spin, 1e-14);
}

}  // namespace
}  // namespace rubsweep::model
