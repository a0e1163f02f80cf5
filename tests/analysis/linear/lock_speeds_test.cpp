#include "rubsweep/analysis/linear/lock_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::linear {
namespace {

/// A forward and a backward whirl of the same frequency w lock at the speed W = w (p + q) / (p - q).
TEST(LockSpeeds, OfAJeffcottRotorAreTwoThreeAndFiveTimesItsFrequency) {
  const Campbell diagram =
      campbell(free_rotor(scene::one_side_machine()), batch::evenly_spaced(0, 200, 37), 400);
  const std::vector<LockSpeed> found = lock_speeds(diagram);
  const double damped_hz = 30 * std::sqrt(1 - 0.02 * 0.02);
  ASSERT_EQ(found.size(), 3u);
  const LockSpeed expected[]{
      {2, 1, 3, 1, 2 * damped_hz}, {2, 1, 2, 1, 3 * damped_hz}, {2, 1, 3, 2, 5 * damped_hz}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(found[k].first, expected[k].first) << "the forward one";
    EXPECT_EQ(found[k].second, expected[k].second);
    EXPECT_EQ(found[k].p, expected[k].p);
    EXPECT_EQ(found[k].q, expected[k].q);
    EXPECT_NEAR(found[k].speed_hz, expected[k].speed_hz, 1e-9 * damped_hz);
  }
}

TEST(LockSpeeds, NoneOfAModeThatIsDampedAway) {
  Campbell diagram = campbell(free_rotor(scene::one_side_machine()), batch::evenly_spaced(0, 200, 37), 400);
  for (CampbellPoint& point : diagram.modes.front().points) point.damping_ratio = 0.6;
  EXPECT_TRUE(lock_speeds(diagram).empty());
}

TEST(LockSpeeds, NoneOfAPieceAtWhoseBeginningAModeIsDampedAway) {
  const double speeds[]{50, 65};  // the lock at 60 Hz is between them
  for (const double damped_at_hz : speeds) {
    Campbell diagram = campbell(free_rotor(scene::one_side_machine()), std::vector<double>{50, 65, 80}, 400);
    for (CampbellPoint& point : diagram.modes.front().points)
      if (point.speed_hz == damped_at_hz) point.damping_ratio = 0.6;
    EXPECT_TRUE(lock_speeds(diagram).empty()) << damped_at_hz;
  }
}

/// A mode listed as backward after being forward jumps from -f to f: no lock speed lies between.
TEST(LockSpeeds, NoneWhereAModeChangesItsDirection) {
  Campbell diagram = campbell(free_rotor(scene::one_side_machine()), batch::evenly_spaced(0, 200, 37), 400);
  for (CampbellPoint& point : diagram.modes.front().points)
    if (point.speed_hz < 20) point.forward_share = 1 - point.forward_share;
  EXPECT_EQ(lock_speeds(diagram).size(), 3u);
}

Campbell split(double forward_slope) {
  Campbell diagram;
  for (const double speed : {0.0, 10.0, 20.0, 30.0, 40.0}) {
    if (speed == 0) diagram.modes = {{.number = 1, .points = {}}, {.number = 2, .points = {}}};
    diagram.modes[0].points.push_back({speed, 10 - 0.1 * speed, 0, 0});
    diagram.modes[1].points.push_back({speed, 10 + forward_slope * speed, 0, 1});
  }
  return diagram;
}

/// Straight branches lead to a linear equation: W = (p w_f + q w_b) / (p - q).
TEST(LockSpeeds, FollowTheBranchesOverTheSpeed) {
  const std::vector<LockSpeed> found = lock_speeds(split(0.2));
  ASSERT_EQ(found.size(), 1u);
  // For p = 3, q = 1: 2 W = 3 (10 + 0.2 W) + (10 - 0.1 W) gives W = 40 / 1.5.
  EXPECT_EQ(found[0].p, 3);
  EXPECT_NEAR(found[0].speed_hz, 40 / 1.5, 1e-9);
}

TEST(LockSpeeds, OnASpeedOfTheDiagramAreFoundOnce) {
  // 2 W = 3 (10 + 0.2 W) + ... has the solution 40 / (2 - 3 s - (-0.1)) = 20 for s = 0.1 / 3.
  const std::vector<LockSpeed> found = lock_speeds(split(0.1 / 3));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].speed_hz, 20, 1e-9);
  EXPECT_NEAR(found[1].speed_hz, 30 / (1 - 2 * 0.1 / 3 + 0.1), 1e-9) << "p = 2, q = 1";
}

/// A mode overdamped at the lowest speeds has fewer points than the other one, so points are matched by
/// speed.
TEST(LockSpeeds, OfAModeThatBeginsLaterAreThoseOfTheSamePieces) {
  Campbell diagram = split(0.2);
  auto& points = diagram.modes[1].points;
  points.erase(points.begin(), points.begin() + 2);
  const std::vector<LockSpeed> found = lock_speeds(diagram);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].speed_hz, 40 / 1.5, 1e-9);
  points.erase(points.begin());  // the mode begins at 30 Hz, above the lock speed
  EXPECT_TRUE(lock_speeds(diagram).empty());
}

TEST(LockSpeeds, NoneOfASingleMode) {
  Campbell diagram = split(0.2);
  diagram.modes.pop_back();
  EXPECT_TRUE(lock_speeds(diagram).empty());
}

}  // namespace

}  // namespace rubsweep::linear
