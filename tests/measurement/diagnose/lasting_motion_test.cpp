#include "rubsweep/measurement/diagnose/lasting_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/diagnose/drawn_machine.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

/// Numbers of a machine that rubs after its kick, and a kick that does.
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

TEST(LastingMotion, IsTheOneThatAVerdictIsGivenOn) {
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

TEST(LastingMotion, IsRecordedWhenFreeVibrationHasDiedAway) {
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

TEST(LastingMotion, WithoutContactIsTheWhirlOfTheUnbalance) {
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

TEST(LastingMotion, ThatFallsBackIsNone) {
  response::spectrum::SpectrumWorkspace spectrum;
  Point values = rubbing_point();
  values[static_cast<std::size_t>(Unknown::kick_ratio)] = 0.05;
  EXPECT_FALSE(rubbing_motion(drawn_machine(Cause::one_side, values, 1e-4, {}), 70, scene::WhirlRatio{0.3},
                              12, spectrum));
}

TEST(LastingMotion, EndsAfterTheTurnsThatAreSaid) {
  const int turns = turns_to_decay(30, 0.02, 70, 1e-5);
  const auto left = [](int count) { return std::exp(-0.02 * 2 * std::numbers::pi * 30 * count / 70.0); };
  EXPECT_LE(left(turns), 1e-5);
  EXPECT_GT(left(turns - 1), 1e-5);
}

TEST(LastingMotion, WithoutDampingIsNotWaitedForForever) {
  EXPECT_EQ(turns_to_decay(30, 0, 70, 1e-5), 1'000'000);
}

}  // namespace
}  // namespace rubsweep::diagnose
