#include "rubsweep/core/integrate/run/pulse_times.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rubsweep::integrate::run {
namespace {

using std::numbers::pi;
using Numbers = std::vector<std::size_t>;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr StateScale seconds{.length_m = 1e-3, .speed_rad_per_s = 1};

/// A scene with pulses along x, each given by force, duration and time since its start.
scene::Scene scene_with_pulses(const std::vector<std::array<double, 3>>& pulses) {
  scene::Scene scene;
  for (const auto& [force_n, duration_s, elapsed_s] : pulses)
    scene.pulses.push_back({Eigen::Vector2d(1, 0), force_n, duration_s, elapsed_s});
  return scene;
}

TEST(PulseTimes, NoneNeverChange) {
  PulseTimes none(scene_with_pulses({}), seconds, 1);
  EXPECT_FALSE(none.begin_turn(0));
  EXPECT_EQ(none.next_change(), never);
  EXPECT_TRUE(none.acting().empty());
}

TEST(PulseTimes, AKickActsFromTheStartToItsEnd) {
  PulseTimes kick(scene_with_pulses({{5, 0.25, 0}}), seconds, 1);
  EXPECT_TRUE(kick.begin_turn(0));
  EXPECT_EQ(kick.acting(), Numbers{0});
  EXPECT_EQ(kick.next_change(), 0.25);
  EXPECT_DOUBLE_EQ(kick.angle_rad(0, 0.125), pi / 2);
  EXPECT_FALSE(kick.go_to(std::nextafter(0.25, 0.0)));
  EXPECT_TRUE(kick.go_to(0.25));
  EXPECT_TRUE(kick.acting().empty());
  EXPECT_EQ(kick.next_change(), never);
  EXPECT_FALSE(kick.begin_turn(1));
}

TEST(PulseTimes, APulseMayLastOverTurnsAndBeginInALaterOne) {
  PulseTimes pulse(scene_with_pulses({{5, 1.5, -1.25}}), seconds, 1);
  EXPECT_FALSE(pulse.begin_turn(0));
  EXPECT_EQ(pulse.next_change(), 1.25);  // not in this turn
  EXPECT_FALSE(pulse.begin_turn(1));
  EXPECT_TRUE(pulse.go_to(0.25));
  EXPECT_EQ(pulse.acting(), Numbers{0});
  EXPECT_EQ(pulse.angle_rad(0, 0.25), 0);
  EXPECT_EQ(pulse.elapsed(0), -0.25);
  EXPECT_FALSE(pulse.begin_turn(2));  // the pulse continues
  EXPECT_EQ(pulse.acting(), Numbers{0});
  EXPECT_DOUBLE_EQ(pulse.angle_rad(0, 0), pi / 2);
  EXPECT_EQ(pulse.next_change(), 0.75);
  EXPECT_TRUE(pulse.go_to(0.75));
  EXPECT_TRUE(pulse.acting().empty());
}

TEST(PulseTimes, OverlappingOnesComeAndGoOneByOne) {
  PulseTimes two(scene_with_pulses({{5, 0.5, -0.25}, {-3, 0.5, 0}}), seconds, 1);
  EXPECT_TRUE(two.begin_turn(0));
  EXPECT_EQ(two.acting(), Numbers{1});
  EXPECT_EQ(two.next_change(), 0.25);
  EXPECT_TRUE(two.go_to(0.25));
  EXPECT_EQ(two.acting(), (Numbers{0, 1}));
  EXPECT_TRUE(two.go_to(0.5));
  EXPECT_EQ(two.acting(), Numbers{0});
  EXPECT_EQ(two.next_change(), 0.75);
  EXPECT_TRUE(two.go_to(0.75));
  EXPECT_TRUE(two.acting().empty());
}

/// A pulse that begins when another one ends: the force changes although one pulse acts throughout.
TEST(PulseTimes, TheEndOfOneMayBeTheBeginningOfAnother) {
  PulseTimes two(scene_with_pulses({{5, 0.25, 0}, {5, 0.25, -0.25}}), seconds, 1);
  EXPECT_TRUE(two.begin_turn(0));
  EXPECT_TRUE(two.go_to(0.25));
  EXPECT_EQ(two.acting(), Numbers{1});
}

TEST(PulseTimes, OneWithoutForceIsNone) {
  PulseTimes none(scene_with_pulses({{0, 0.25, 0}}), seconds, 1);
  EXPECT_FALSE(none.begin_turn(0));
  EXPECT_EQ(none.next_change(), never);
}

TEST(PulseTimes, CountInTheTimeOfTheScale) {
  const StateScale radians{.length_m = 1e-3, .speed_rad_per_s = 8 * pi};
  PulseTimes kick(scene_with_pulses({{5, 0.0625, -0.25}}), radians, 2 * pi);
  EXPECT_TRUE(kick.begin_turn(1));
  EXPECT_DOUBLE_EQ(kick.next_change(), pi / 2);
  EXPECT_DOUBLE_EQ(kick.angle_rad(0, pi / 4), pi / 2);
}

}  // namespace
}  // namespace rubsweep::integrate::run
