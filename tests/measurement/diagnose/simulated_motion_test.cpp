#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/diagnose/drawn_machine.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose {
namespace {

/// Values for a rotor of 30 Hz with a hard flat stop.
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
  // The kick of a thousandth of the clearance has decayed by a factor of 1e-5.
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

/// Values for a machine that rubs after its kick.
Point rubbing_point() {
  Point values{};
  const auto set = [&](Unknown unknown, double value) { values[static_cast<std::size_t>(unknown)] = value; };
  set(Unknown::natural_frequency, 30);
  set(Unknown::damping_ratio, 0.02);
  set(Unknown::whirl_ratio, 0.7);
  set(Unknown::stiffness, 1e6);
  set(Unknown::restitution, 0.8);
  set(Unknown::friction, 0.1);
  set(Unknown::casing_mass, 0.2);
  set(Unknown::casing_frequency, 400);
  set(Unknown::kick_ratio, 3);
  set(Unknown::second_clearance_ratio, 1);
  return values;
}

TEST(SimulatedMotionLastingMotion, IsTheOneThatAVerdictIsGivenOn) {
  response::motion::Workspace workspace;
  response::spectrum::SpectrumWorkspace spectrum;
  int compared = 0;
  for (const double speed_hz : {62.0, 66.0, 70.0, 93.0, 100.0}) {
    const model::Machine machine = drawn_machine(Cause::one_side, rubbing_point(), 1e-4, {});
    const auto judged = simulate_motion(machine, speed_hz, scene::WhirlRatio{0.7}, 30, workspace);
    const auto lasting = rubbing_motion(machine, speed_hz, scene::WhirlRatio{0.7}, 30, spectrum);
    ASSERT_TRUE(judged);
    ASSERT_EQ(lasting.has_value(), judged->rubs) << speed_hz;
    if (!lasting || judged->motion_class != response::motion::MotionClass::subharmonic) continue;
    ++compared;
    EXPECT_NEAR(size_of(lasting->lines), size_of(judged->displacement_m),
                1e-3 * size_of(judged->displacement_m));
    EXPECT_NEAR(lasting->contact.contact_fraction, judged->contact.contact_fraction, 1e-3);
    EXPECT_DOUBLE_EQ(lasting->eccentricity_m, judged->eccentricity_m);
  }
  EXPECT_GT(compared, 0);
}

TEST(SimulatedMotionLastingMotion, IsRecordedWhenFreeVibrationHasDiedAway) {
  const auto turns_with = [](double damping_ratio) {
    Point values = rubbing_point();
    values[static_cast<std::size_t>(Unknown::damping_ratio)] = damping_ratio;
    return turns_before_recording(drawn_machine(Cause::one_side, values, 1e-4, {}), 70);
  };
  EXPECT_EQ(turns_with(0.2), fewest_turns_before_recording);
  EXPECT_EQ(turns_with(0.002), most_turns_before_recording);
  const int turns = turns_with(0.01);
  const auto left = [](int count) { return std::exp(-0.01 * 2 * std::numbers::pi * 30 * count / 70.0); };
  EXPECT_LE(left(turns), 1.0 / 200);
  EXPECT_GT(left(turns - 1), 1.0 / 200);
  model::Machine kit;
  kit.rotor = model::RotorKit{};
  EXPECT_EQ(turns_before_recording(kit, 70), kit_turns_before_recording);
}

TEST(SimulatedMotionLastingMotion, WithoutContactIsTheWhirlOfTheUnbalance) {
  response::spectrum::SpectrumWorkspace spectrum;
  Point values = rubbing_point();
  const model::Machine machine = drawn_machine(Cause::no_rub, values, 1e-4, {});
  const double speed_hz = 70, r = speed_hz / 30, damping = 0.02;
  const auto motion = motion_without_contact(machine, speed_hz, scene::Eccentricity{1e-5}, 12, spectrum);
  ASSERT_TRUE(motion);
  const double amplitude = 1e-5 * r * r / std::hypot(1 - r * r, 2 * damping * r);
  EXPECT_NEAR(std::abs(motion->lines.at(12)), amplitude, 1e-6 * amplitude);
  EXPECT_NEAR(size_of(motion->lines), amplitude, 1e-6 * amplitude);
}

TEST(SimulatedMotionLastingMotion, ThatFallsBackIsNone) {
  response::spectrum::SpectrumWorkspace spectrum;
  Point values = rubbing_point();
  values[static_cast<std::size_t>(Unknown::kick_ratio)] = 0.05;
  EXPECT_FALSE(rubbing_motion(drawn_machine(Cause::one_side, values, 1e-4, {}), 70, scene::WhirlRatio{0.3},
                              12, spectrum));
}

TEST(SimulatedMotionLastingMotion, EndsAfterTheTurnsThatAreSaid) {
  const int turns = turns_to_decay(30, 0.02, 70, 1e-5);
  const auto left = [](int count) { return std::exp(-0.02 * 2 * std::numbers::pi * 30 * count / 70.0); };
  EXPECT_LE(left(turns), 1e-5);
  EXPECT_GT(left(turns - 1), 1e-5);
}

TEST(SimulatedMotionLastingMotion, WithoutDampingIsNotWaitedForForever) {
  EXPECT_EQ(turns_to_decay(30, 0, 70, 1e-5), 1'000'000);
}

}  // namespace
}  // namespace rubsweep::diagnose
