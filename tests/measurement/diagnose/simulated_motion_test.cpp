#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/measurement/diagnose/drawn_machine.hpp"

namespace rubsweep::diagnose {
namespace {

/// A rotor of 30 Hz with a hard flat stop.
Point values_of(double whirl_ratio, double kick_ratio) {
  Candidate candidate = usual_candidate(Cause::one_side);
  spread_of(candidate, Unknown::natural_frequency) = {30, 30};
  spread_of(candidate, Unknown::damping_ratio) = {0.02, 0.02};
  spread_of(candidate, Unknown::stiffness) = {2e6, 2e6};
  spread_of(candidate, Unknown::restitution) = {0.7, 0.7};
  spread_of(candidate, Unknown::friction) = {0.1, 0.1};
  spread_of(candidate, Unknown::casing_mass) = {0.05, 0.05};
  spread_of(candidate, Unknown::casing_frequency) = {500, 500};
  spread_of(candidate, Unknown::whirl_ratio) = {whirl_ratio, whirl_ratio};
  spread_of(candidate, Unknown::kick_ratio) = {kick_ratio, kick_ratio};
  spread_of(candidate, Unknown::kick_angle) = {0, 0};
  spread_of(candidate, Unknown::kick_phase) = {0, 0};
  return values_at(candidate, {});
}

std::optional<SimulatedMotion> run(double speed_hz, double whirl_ratio, double kick_ratio, int turns) {
  response::motion::Workspace workspace;
  return simulate_motion(
      drawn_machine(Cause::one_side, values_of(whirl_ratio, kick_ratio), 1e-3, {.rotor_mass_kg = 0.8}),
      speed_hz, scene::WhirlRatio{whirl_ratio}, turns, workspace);
}

TEST(SimulatedMotion, WithoutContactIsTheCircleOfTheUnbalance) {
  const auto motion = run(70, 0.3, 1e-3, 4);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->rubs);
  EXPECT_TRUE(motion->kicked);
  ASSERT_EQ(motion->displacement_m.size(), std::size_t{4 * samples_per_revolution});
  // A hundred thousandth of the tap is left, of a thousandth of the clearance.
  for (const auto z : motion->displacement_m) EXPECT_NEAR(std::abs(z), 0.3e-3, 1e-10);
  const double r = 70.0 / 30;
  EXPECT_NEAR(motion->eccentricity_m * r * r / std::hypot(1 - r * r, 2 * 0.02 * r), 0.3e-3, 1e-9);
}

TEST(SimulatedMotion, OfAWhirlThatTouchesIsNotKicked) {
  const auto motion = run(70, 1.2, 1, 4);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->kicked);
}

TEST(SimulatedMotion, AKickThatDoesNotReachTheStopLeavesNoFreeVibration) {
  const auto motion = run(70, 0.05, 0.9, 8);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->rubs);
  double smallest = INFINITY, largest = 0;
  for (const auto z : motion->displacement_m) {
    smallest = std::min(smallest, std::abs(z));
    largest = std::max(largest, std::abs(z));
  }
  EXPECT_LT(largest - smallest, 1e-3 * largest);
}

TEST(SimulatedMotion, OfAKickedRotorRepeatsAfterItsOrder) {
  const auto motion = run(70, 0.6, 10, 16);
  ASSERT_TRUE(motion);
  EXPECT_TRUE(motion->rubs);
  ASSERT_TRUE(motion->order);
  ASSERT_GE(*motion->order, 2);
  ASSERT_LE(*motion->order, 8);
  const auto& z = motion->displacement_m;
  const auto period = static_cast<std::size_t>(*motion->order * samples_per_revolution);
  double after_one = 0, after_order = 0;
  for (std::size_t k = 0; k + period < z.size(); ++k) {
    after_one = std::max(after_one, std::abs(z[k + samples_per_revolution] - z[k]));
    after_order = std::max(after_order, std::abs(z[k + period] - z[k]));
  }
  EXPECT_GT(after_one, 1e-4);
  EXPECT_LT(after_order, 1e-7);
  EXPECT_GT(motion->contact.contact_fraction, 0);
  EXPECT_GT(motion->contact.peak_contact_force_n, 0);
}

}  // namespace
}  // namespace rubsweep::diagnose
