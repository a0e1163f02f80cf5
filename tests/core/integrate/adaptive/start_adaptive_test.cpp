#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/integrate/adaptive/with.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

using Complex = std::complex<double>;
constexpr Complex i{0, 1};

/// Displacement z = x + iy of the first point after `turns` revolutions, in metres.
Complex displacement_after(const scene::Scene& scene, const run::SolverOptions& options, int turns) {
  const run::Cursor advance = start_adaptive(scene, options);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(advance({}, turn), run::Outcome::ok);
  return scene.length_scale_m * Complex(turn.section[0], turn.section[1]);
}

std::string stepper_name(const testing::TestParamInfo<run::Stepper>& stepper) {
  return std::string(row_of(stepper.param).word);
}

/// Tests of closed-form motions, run with every stepper.
class StartAdaptiveEveryStepper : public testing::TestWithParam<run::Stepper> {};

INSTANTIATE_TEST_SUITE_P(Adaptive, StartAdaptiveEveryStepper,
                         testing::ValuesIn(single_steppers().begin(), single_steppers().end()), stepper_name);

TEST_P(StartAdaptiveEveryStepper, FreeOscillator) {
  const double m = 2, k = 50, zeta = 0.1, w0 = std::sqrt(k / m), wd = w0 * std::sqrt(1 - zeta * zeta);
  auto scene = test::one_mass_scene(m, k, 2 * zeta * m * w0, 0.7, 1e-3);
  scene.displacement_m << 3e-4, -2e-4;
  scene.velocity_m_per_s << -1e-3, 2e-3;
  const double t = 5 * 0.7;
  const Complex z0(3e-4, -2e-4), v0(-1e-3, 2e-3);
  const Complex z =
      std::exp(-zeta * w0 * t) * (z0 * std::cos(wd * t) + (v0 + zeta * w0 * z0) / wd * std::sin(wd * t));
  EXPECT_LT(std::abs(displacement_after(scene, with(GetParam(), 1e-9), 5) - z), 1e-7 * scene.length_scale_m);
}

TEST_P(StartAdaptiveEveryStepper, ForcedOscillatorFromRestWithConstantForce) {
  const double m = 1, k = 400, c = 2, T = 0.25, w = 2 * std::numbers::pi / T, force = 0.3, load = -0.8;
  auto scene = test::one_mass_scene(m, k, c, T, 1e-3);
  scene.harmonic_n << force, -i * force;
  scene.constant_n << 0, load;
  // z = A e^{iwt} + i load / k + a free vibration that cancels both at t = 0.
  const Complex amplitude = force / Complex(k - m * w * w, c * w), sag = i * load / k;
  const double decay = c / (2 * m), wd = std::sqrt(k / m - decay * decay), t = 3 * T;
  const Complex z0 = -amplitude - sag, v0 = -i * w * amplitude;
  const Complex free =
      std::exp(-decay * t) * (z0 * std::cos(wd * t) + (v0 + decay * z0) / wd * std::sin(wd * t));
  const Complex z = amplitude * std::exp(i * (w * t)) + sag + free;
  EXPECT_LT(std::abs(displacement_after(scene, with(GetParam(), 1e-9), 3) - z), 1e-7 * scene.length_scale_m);
}

/// Without damping z = F W / (m (w0^2 - W^2)) (sin W t / W - sin w0 t / w0), where W is the angular frequency
/// of the half-sine.
TEST_P(StartAdaptiveEveryStepper, AKickOverSeveralTurns) {
  const double m = 1, k = 400, T = 0.25, force = 0.3, duration = 2.4 * T;
  auto scene = test::one_mass_scene(m, k, 0, T, 1e-3);
  scene.pulses = {{Eigen::Vector2d(1, 0), force, duration}};
  const double w0 = std::sqrt(k / m), w = std::numbers::pi / duration, t = 2 * T;
  const double x = force * w / (m * (w0 * w0 - w * w)) * (std::sin(w * t) / w - std::sin(w0 * t) / w0);
  EXPECT_LT(std::abs(displacement_after(scene, with(GetParam(), 1e-9), 2) - x), 5e-8 * scene.length_scale_m);
}

TEST_P(StartAdaptiveEveryStepper, GyroscopicTermSplitsTheWhirlSpeeds) {
  // z'' - i g z' + k z = 0: whirl speeds g/2 +- sqrt(g^2/4 + k); x'' = -g y' - k x, y'' = g x' - k y.
  const double k = 100, g = 3, T = 0.5;
  auto scene = test::one_mass_scene(1, k, 0, T, 1e-3);
  scene.structure.damping << 0, g, -g, 0;
  scene.displacement_m << 5e-4, 0;
  const double root = std::sqrt(g * g / 4 + k), forward = g / 2 + root, backward = g / 2 - root, t = 4 * T;
  const Complex z = 5e-4 * (forward * std::exp(i * (backward * t)) - backward * std::exp(i * (forward * t))) /
                    (forward - backward);
  EXPECT_LT(std::abs(displacement_after(scene, with(GetParam(), 1e-9), 4) - z), 1e-7 * scene.length_scale_m);
}

TEST_P(StartAdaptiveEveryStepper, KickLongerThanATurn) {
  // x'' + w0^2 x = F sin(p t), p = pi / D: x = F/(w0^2 - p^2) (sin p t - p/w0 sin w0 t) during the kick, then
  // free vibration.
  const double w0 = 9, T = 0.3, duration = 1.1, p = std::numbers::pi / duration, force = 0.02;
  auto scene = test::one_mass_scene(1, w0 * w0, 0, T, 1e-3);
  scene.pulses = {{Eigen::Vector2d(1, 0), force, duration}};
  const double gain = force / (w0 * w0 - p * p);
  const double x1 = gain * (std::sin(p * duration) - p / w0 * std::sin(w0 * duration));
  const double v1 = gain * p * (std::cos(p * duration) - std::cos(w0 * duration));
  const double t = 6 * T - duration;
  const double x = x1 * std::cos(w0 * t) + v1 / w0 * std::sin(w0 * t);
  EXPECT_LT(std::abs(displacement_after(scene, with(GetParam(), 1e-9), 6) - x), 5e-7 * scene.length_scale_m);
}

TEST_P(StartAdaptiveEveryStepper, RubbingRunAgreesWithTheLongDoubleReference) {
  const test::OneSideRotor rotor;
  static const auto reference = test::long_double_sections(rotor, 12);
  const double tolerance = GetParam() == run::Stepper::rosenbrock4 ? 1e-8 : 1e-10;
  const run::Cursor advance = start_adaptive(test::cell_of(rotor).scene, with(GetParam(), tolerance));
  run::TurnReport turn;
  int hits = 0;
  for (std::size_t k = 1; k < reference.size(); ++k) {
    ASSERT_EQ(advance({}, turn), run::Outcome::ok);
    hits += turn.hits;
    EXPECT_LT(test::section_error(turn.section, reference[k], rotor), 1e3 * tolerance) << "turn " << k;
  }
  EXPECT_EQ(hits, 6);  // the 1/2 subharmonic: one hit every other turn
}

/// A single elastic shock with a closed form, code_aster test SDND101: m = 100 kg, k = 1e4 N/m, a wall of K =
/// 1e6 N/m without gap, v(0) = 1 m/s towards the wall.
TEST_P(StartAdaptiveEveryStepper, SingleElasticShock) {
  auto scene = test::one_mass_scene(100, 1e4, 0, 1, 1e-2);
  scene.contacts.push_back(test::wall_across_x(1, 0, 1e6, 0));
  scene.velocity_m_per_s << 1, 0;
  const run::Cursor advance = start_adaptive(scene, with(GetParam(), 1e-10));
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.peaks = asked.switches = true;
  ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
  const double in_contact = std::sqrt(1.01e6 / 100), in_flight = 10, pi = std::numbers::pi;
  EXPECT_NEAR(turn.peak_contact_force_n, 1e6 / in_contact, 1e-4 * 9950.37);
  ASSERT_GE(turn.switches.size(), 2u);
  const double seconds = 1 / (2 * pi);
  EXPECT_EQ(turn.switches[0].from, contact::Mode::sprung);                   // in contact from the start
  EXPECT_NEAR(turn.switches[0].phase_rad * seconds, pi / in_contact, 1e-9);  // 0.03126 s
  EXPECT_NEAR(turn.switches[1].phase_rad * seconds, pi / in_contact + pi / in_flight, 1e-9);  // next touch
}

TEST_P(StartAdaptiveEveryStepper, SamplingDoesNotChangeTheRun) {
  const auto cell = test::cell_of({});
  const run::Cursor plain = start_adaptive(cell.scene, with(GetParam(), 1e-8));
  const run::Cursor sampled = start_adaptive(cell.scene, with(GetParam(), 1e-8));
  run::TurnRequest asked;
  run::TurnReport a, b;
  asked.samples_per_revolution = 50;
  asked.peaks = asked.switches = true;
  std::vector<double> before = run::scaled_initial_state(cell.scene);
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(plain({}, a), run::Outcome::ok);
    ASSERT_EQ(sampled(asked, b), run::Outcome::ok);
    ASSERT_EQ(a.section, b.section);
    EXPECT_TRUE(
        std::equal(before.begin(), before.end(), b.samples.begin()));  // sample 0: section at the start
    before = b.section;
  }
}

TEST(StartAdaptive, SamplesOfAllSteppersAgree) {
  const auto cell = test::cell_of({});
  const auto samples = [&](run::Stepper stepper) {
    const run::Cursor advance =
        start_adaptive(cell.scene, with(stepper, stepper == run::Stepper::rosenbrock4 ? 1e-9 : 1e-10));
    run::TurnReport turn;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(advance({.samples_per_revolution = 37}, turn), run::Outcome::ok);
    return turn.samples;
  };
  const std::vector<double> reference = samples(run::Stepper::rkf78);
  ASSERT_FALSE(reference.empty());
  for (const run::Stepper stepper : single_steppers()) {
    const std::vector<double> found = samples(stepper);
    ASSERT_EQ(found.size(), reference.size());
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], reference[k], 2e-7) << row_of(stepper).word << k;
  }
}

TEST(StartAdaptive, ModesFollowTheRulesAndTheHitIsCountedOnce) {
  const run::Cursor advance = start_adaptive(test::cell_of({}).scene, with(run::Stepper::dopri5, 1e-9));
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.switches = true;
  contact::Mode mode = contact::Mode::open;
  int hits = 0, entries = 0;
  for (int k = 0; k < 10; ++k) {
    ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
    double last_phase = 0;
    for (const run::ModeSwitch& change : turn.switches) {
      EXPECT_EQ(change.from, mode);
      EXPECT_GE(change.phase_rad, last_phase);
      last_phase = change.phase_rad;
      if (change.from == contact::Mode::open) ++entries;
      mode = change.to;
    }
    hits += turn.hits;
  }
  EXPECT_EQ(hits, entries);
  EXPECT_GT(hits, 0);
}

TEST(StartAdaptive, GrazeIsAHitOnlyWhenThePeakPassesTheWall) {
  // x = A cos(w0 t), released at -A: the peak A comes after half a period; the wall stands at A - depth.
  for (const double depth : {-1e-9, 1e-9}) {
    for (const run::Stepper stepper : {run::Stepper::dopri5, run::Stepper::rkf78}) {
      auto scene = test::one_mass_scene(1, 400, 0, 0.25, 1.0);
      scene.displacement_m << -1, 0;
      scene.contacts.push_back(test::wall_across_x(1, 1 - depth, 1e4, 1));
      const run::Cursor advance = start_adaptive(scene, with(stepper, 1e-12));
      run::TurnReport turn;
      ASSERT_EQ(advance({}, turn), run::Outcome::ok);
      EXPECT_EQ(turn.hits, depth > 0 ? 1 : 0) << depth << " stepper " << row_of(stepper).word;
    }
  }
}

TEST(StartAdaptive, TwoWallsHitAtOnceStaySymmetric) {
  auto scene = test::one_mass_scene(1, 100, 0, 0.5, 1e-3);
  for (const int sign : {1, -1}) {
    scene::Contact wall = test::wall_across_x(1, 1e-3, 1e5, 20);
    wall.wall = contact::FlatWall{{std::sqrt(0.5), sign * std::sqrt(0.5)}};
    scene.contacts.push_back(wall);
  }
  scene.velocity_m_per_s << 1, 0;
  const run::Cursor advance = start_adaptive(scene, with(run::Stepper::dopri5, 1e-9));
  run::TurnReport turn;
  int hits = 0;
  for (int k = 0; k < 5; ++k) {
    ASSERT_EQ(advance({}, turn), run::Outcome::ok);
    hits += turn.hits;
    EXPECT_NEAR(turn.section[1], 0, 1e-12);
  }
  EXPECT_GE(hits, 2);
  EXPECT_EQ(hits % 2, 0);
}

TEST(StartAdaptive, StepLimitIsAnOutcome) {
  run::SolverOptions options = with(run::Stepper::dopri5, 1e-12);
  options.max_steps_per_revolution = 20;
  run::TurnReport turn;
  EXPECT_EQ(start_adaptive(test::cell_of({}).scene, options)({}, turn), run::Outcome::step_limit);
  EXPECT_EQ(turn.effort.steps + turn.effort.refused, 20);
}

TEST(StartAdaptive, EvaluationsOfATurnAreBoundedWhateverAStepAsksFor) {
  // One step by extrapolation needs dozens of evaluations.
  run::SolverOptions options = with(run::Stepper::bulirsch_stoer, 1e-13);
  options.max_steps_per_revolution = 20;
  run::TurnReport turn;
  EXPECT_EQ(start_adaptive(test::cell_of({}).scene, options)({}, turn), run::Outcome::step_limit);
  EXPECT_LT(turn.effort.steps + turn.effort.refused, 20);
  EXPECT_GE(turn.effort.rhs_calls, run::most_evaluations_of_a_turn(options));
  EXPECT_LT(turn.effort.rhs_calls, 10 * run::most_evaluations_of_a_turn(options));
}

TEST(StartAdaptive, NonFiniteStatesAreAnOutcome) {
  auto scene = test::one_mass_scene(1, 1, 0, 1, 1);
  scene.constant_n << std::numeric_limits<double>::infinity(), 0;
  for (const run::Stepper stepper :
       {run::Stepper::dopri5, run::Stepper::cash_karp54, run::Stepper::rkf78, run::Stepper::bulirsch_stoer}) {
    run::TurnReport turn;
    const run::Outcome outcome = start_adaptive(scene, with(stepper, 1e-8))({}, turn);
    EXPECT_TRUE(outcome == run::Outcome::non_finite || outcome == run::Outcome::step_too_small)
        << row_of(stepper).word;
  }
}

TEST(StartAdaptive, RunawayEndsAsAnOutcome) {
  // Negative damping: e^{1e4 t} overflows within the turn.
  auto scene = test::one_mass_scene(1, 1, -1e4, 1, 1);
  scene.displacement_m << 1, 0;
  run::TurnReport turn;
  const run::Outcome outcome = start_adaptive(scene, with(run::Stepper::dopri5, 1e-6))({}, turn);
  EXPECT_TRUE(outcome == run::Outcome::non_finite || outcome == run::Outcome::step_too_small);
}

TEST(StartAdaptive, EightCoordinatesTakeTheDynamicPath) {
  // Three stops with casings: the two additional walls are out of reach and must not change anything.
  const test::OneSideRotor rotor;
  model::Machine machine = test::machine_of(rotor);
  model::Stop far = machine.stops[0];
  far.clearance_m = 1;
  for (const double angle : {0.0, 180.0}) {
    far.geometry = model::OneSideGeometry{angle};
    machine.stops.push_back(far);
  }
  const auto cell = scene::build_cell(machine, rotor.speed_hz, scene::WhirlRatio{rotor.whirl_ratio});
  ASSERT_EQ(cell.scene.structure.coordinates(), 8);
  const run::Cursor advance = start_adaptive(cell.scene, with(run::Stepper::dopri5, 1e-10));
  const auto reference = test::long_double_sections(rotor, 4);
  run::TurnReport turn;
  for (std::size_t k = 1; k < reference.size(); ++k) {
    ASSERT_EQ(advance({}, turn), run::Outcome::ok);
    const auto& s = turn.section;
    const std::vector<double> first{s[0], s[1], s[2], s[3], s[8], s[9], s[10], s[11]};
    EXPECT_LT(test::section_error(first, reference[k], rotor), 1e-7);
  }
}

}  // namespace
}  // namespace rubsweep::integrate::adaptive
