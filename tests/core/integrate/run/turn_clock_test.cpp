#include "rubsweep/core/integrate/run/turn_clock.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::run {
namespace {

/// A scene in which one revolution takes 1 s.
scene::Scene one_second_a_turn() { return test::one_mass_scene(1, 1, 0, 1, 1e-3); }

TurnClock clock_of(const scene::Scene& scene) { return TurnClock::in_seconds(scene, state_scale(scene)); }

/// Instants at which a turn must stop, in the order in which an exact run reaches them.
std::vector<double> boundaries(TurnClock& clock, long revolution) {
  std::vector<double> instants;
  clock.begin_turn(revolution);
  while (!clock.turn_is_over()) {
    while (clock.impulse_is_due()) clock.take_impulse();
    clock.go_to(clock.next_boundary());
    clock.change_pulses();
    instants.push_back(clock.time());
  }
  return instants;
}

TEST(TurnClock, StopsAtImpulsesPulsesAndTheEndOfTheTurn) {
  scene::Scene scene = one_second_a_turn();
  TurnClock quiet = clock_of(scene);
  EXPECT_EQ(boundaries(quiet, 3), std::vector{quiet.period()});
  EXPECT_DOUBLE_EQ(quiet.period(), 1);

  // Two impulses per turn, and a kick that begins in the first turn and ends in the second.
  scene.impulses.push_back({Eigen::Vector2d(0.5, 0), 2, 0.25});
  scene.pulses.push_back({Eigen::Vector2d(1, 0), 5, 0.75, -0.5});
  TurnClock clock = clock_of(scene);
  const std::vector<double> expected[] = {{0.125, 0.5, 0.625, 1}, {0.125, 0.25, 0.625, 1}, {0.125, 0.625, 1}};
  for (long revolution = 0; revolution < 3; ++revolution) {
    const std::vector<double> instants = boundaries(clock, revolution);
    const std::vector<double>& sought = expected[revolution];
    ASSERT_EQ(instants.size(), sought.size()) << revolution;
    for (std::size_t i = 0; i < sought.size(); ++i) EXPECT_NEAR(instants[i], sought[i], 1e-15) << revolution;
  }
}

TEST(TurnClock, SaysWhetherOtherPulsesActThanBefore) {
  scene::Scene scene = one_second_a_turn();
  scene.pulses.push_back({Eigen::Vector2d(1, 0), 5, 0.25, 0});
  TurnClock clock = clock_of(scene);
  EXPECT_TRUE(clock.begin_turn(0));
  clock.go_on(0.2);
  EXPECT_FALSE(clock.change_pulses());
  EXPECT_EQ(clock.pulses().acting().size(), 1);
  clock.go_on(0.1);
  EXPECT_TRUE(clock.change_pulses());
  EXPECT_TRUE(clock.pulses().acting().empty());
  EXPECT_FALSE(clock.begin_turn(1));
}

TEST(TurnClock, CountsTimePhaseAndTurns) {
  TurnClock clock = clock_of(test::one_mass_scene(1, 1, 0, 0.5, 1e-3));
  clock.go_to_phase(std::numbers::pi);
  EXPECT_DOUBLE_EQ(clock.time(), 0.25);
  clock.go_on(0.125);
  EXPECT_DOUBLE_EQ(clock.phase_rad(), 1.5 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(clock.turns(0.125), 0.25);
  EXPECT_FALSE(clock.turn_is_over());
  clock.begin_turn(1);
  EXPECT_EQ(clock.time(), 0);
}

TEST(TurnClock, InRadiansATurnMayEndEarlier) {
  scene::Scene scene = one_second_a_turn();
  scene.impulses.push_back({Eigen::Vector2d(0.5, 0), 2, 0.25});
  TurnClock clock = TurnClock::in_radians(scene, state_scale(scene));
  EXPECT_DOUBLE_EQ(clock.period(), 2 * std::numbers::pi);
  clock.begin_turn(0, 1);
  EXPECT_NEAR(clock.next_boundary(), std::numbers::pi / 4, 1e-15);
  clock.take_impulse();
  EXPECT_EQ(clock.next_boundary(), 1);
  clock.go_to(1);
  EXPECT_TRUE(clock.turn_is_over());
  EXPECT_EQ(clock.phase_rad(), 1);
}

}  // namespace
}  // namespace rubsweep::integrate::run
