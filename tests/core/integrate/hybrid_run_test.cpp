#include "rubsweep/core/integrate/hybrid_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/integrate/expect_long_double.hpp"
#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

run::TurnReport run_exact(const scene::Scene& scene, int turns, const run::SolverOptions& options = {}) {
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, options, modes);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(run.advance({}, turn), run::Outcome::ok) << k;
  return turn;
}

run::TurnReport run_adaptive(const scene::Scene& scene, int turns, double tolerance) {
  run::SolverOptions options;
  options.relative_tolerance = tolerance;
  options.stepper = run::Stepper::rkf78;
  const run::Cursor advance = adaptive::start_adaptive(scene, options);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(advance({}, turn), run::Outcome::ok) << k;
  return turn;
}

double difference(const run::TurnReport& a, const run::TurnReport& b) {
  return largest_difference(a.section, b.section);
}

void expect_reference(const test::OneSideRotor& rotor, int turns, int steps, double bound) {
  const run::TurnReport turn = expect_long_double(rotor, turns, steps, bound);
  EXPECT_GT(turn.effort.switches, 4);
  EXPECT_EQ(turn.effort.taylor_turns + turn.effort.adaptive_turns, 0);
}

TEST(HybridRunExact, SetAToRounding) { expect_reference({}, 20, 1000, 1e-12); }

TEST(HybridRunExact, SetBToRounding) { expect_reference(test::set_b_rotor(), 6, 6000, 5e-12); }

TEST(HybridRunExact, AnUndampedStopAndAnUndampedRotor) {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0;
  rotor.casing_damping_ratio = 0;
  expect_reference(rotor, 6, 1500, 1e-11);
}

TEST(HybridRunExact, ACriticallyDampedCasing) {
  test::OneSideRotor rotor;
  rotor.casing_damping_ratio = 1;
  expect_reference(rotor, 6, 1500, 5e-12);
  rotor.casing_damping_ratio = 1 + 1e-9;
  expect_reference(rotor, 3, 1500, 5e-12);
}

TEST(HybridRunExact, ACasingTunedToTheRotor) {
  test::OneSideRotor rotor;  // 30 Hz and equal damping: every mode of the free structure is double
  rotor.casing_mass_kg = 0.8;
  rotor.casing_stiffness_n_per_m = 0.8 * std::pow(2 * std::numbers::pi * 30, 2);
  rotor.casing_damping_ratio = 0.02;
  expect_reference(rotor, 6, 1500, 1e-12);
}

/// The kick ends together with a turn; the run continues without searching for its mode again.
TEST(HybridRunExact, AKickThatEndsWithATurn) {
  for (const int turns : {1, 2}) {
    model::Machine machine = test::machine_of({});
    machine.kick = model::Kick{.force_n = 20, .duration_s = turns / 80.0, .angle_deg = {}};
    const auto cell = scene::build_cell(machine, 80, scene::WhirlRatio{0.4});
    const run::TurnReport exact = run_exact(cell.scene, 5), reference = run_adaptive(cell.scene, 5, 1e-13);
    EXPECT_LT(difference(exact, reference), 1e-9) << turns;
    EXPECT_EQ(exact.effort.taylor_turns + exact.effort.adaptive_turns, 0);
  }
}

/// Several stops at any angle, with gravity, compared with rkf78 at a tight tolerance.
TEST(HybridRunExact, StopsAllAround) {
  model::Machine machine = test::machine_of({});
  machine.gravity_m_per_s2 = 9.81;
  machine.stops[0].geometry = model::OneSideGeometry{90};
  model::Stop second = machine.stops[0];
  second.geometry = model::OneSideGeometry{215};
  second.casing = {};
  model::Stop third = machine.stops[0];
  third.geometry = model::OneSideGeometry{-20};
  machine.stops.push_back(second);
  machine.stops.push_back(third);
  const auto cell = scene::build_cell(machine, 95, scene::WhirlRatio{0.6});
  const run::TurnReport exact = run_exact(cell.scene, 5), reference = run_adaptive(cell.scene, 5, 1e-13);
  EXPECT_LT(difference(exact, reference), 1e-9);
  EXPECT_GT(exact.effort.switches, 8);
  EXPECT_EQ(exact.effort.switches, reference.effort.switches);
  EXPECT_EQ(exact.effort.taylor_turns + exact.effort.adaptive_turns, 0);
}

TEST(HybridRunExact, TransitionIsTheDerivativeOfTheSection) {
  auto scene = test::cell_of({}).scene;
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, {}, modes);
  run::TurnRequest asked;
  run::TurnReport turn;
  run.advance(asked, turn);
  run.advance(asked, turn);
  const std::vector<double> start = turn.section;
  scene.pulses.clear();
  const auto undriven = start_hybrid(scene, {}, modes);
  undriven.restart(start);
  asked.tangent_vectors.setIdentity(8, 8);
  ASSERT_EQ(undriven.advance(asked, turn), run::Outcome::ok);
  ASSERT_GT(turn.hits, 0);
  const Eigen::MatrixXd transition = *turn.tangent_vectors.get();
  asked.tangent_vectors.resize(0, 0);
  constexpr double h = 1e-6;
  for (std::size_t j = 0; j < start.size(); ++j) {
    std::vector<double> shifted = start;
    shifted[j] += h;
    undriven.restart(shifted);
    undriven.advance(asked, turn);
    const std::vector<double> above = turn.section;
    shifted[j] -= 2 * h;
    undriven.restart(shifted);
    undriven.advance(asked, turn);
    for (std::size_t i = 0; i < start.size(); ++i) {
      EXPECT_NEAR(transition(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                  (above[i] - turn.section[i]) / (2 * h), 2e-4)
          << i << ' ' << j;
    }
  }
}

/// Turns that do not propagate tangent vectors report none, neither wrong ones nor those of the turn before.
TEST(HybridRunExact, TangentVectorsThatWereNotMovedAreNotThere) {
  test::OneSideRotor rotor;
  exact::modes::ModeCache modes;
  run::TurnRequest asked;
  asked.tangent_vectors.setIdentity(8, 3);
  run::TurnReport turn;
  int with = 0, without = 0;
  rotor.friction_steepness_s_per_m = 5;
  for (const double radius_m :
       {0.0375, 1e-3}) {  // a fast surface, which keeps friction saturated, and a slow one
    rotor.contact_radius_m = radius_m;
    // A stepper given by name computes the turns without a closed form, and does not propagate tangent
    // vectors.
    const auto run = start_hybrid(test::cell_of(rotor).scene, {.stepper = run::Stepper::dopri5}, modes);
    long before = 0;
    for (int k = 0; k < 12; ++k) {
      ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
      const Eigen::MatrixXd* moved = turn.tangent_vectors.get();
      EXPECT_EQ(moved == nullptr, turn.effort.adaptive_turns > before) << radius_m << ' ' << k;
      before = turn.effort.adaptive_turns;
      if (moved) {
        EXPECT_EQ(moved->cols(), 3);
      }
      ++(moved ? with : without);
    }
  }
  EXPECT_GT(with, 0);
  EXPECT_GT(without, 0);
  const auto scene = test::cell_of(rotor).scene;
  ASSERT_EQ(adaptive::start_adaptive(scene, {})(asked, turn), run::Outcome::ok);
  EXPECT_EQ(turn.tangent_vectors.get(), nullptr);
  const auto by_series = start_hybrid(scene, {}, modes);
  run::TurnReport made;
  for (int k = 0; k < 12; ++k) {
    ASSERT_EQ(by_series.advance(asked, made), run::Outcome::ok);
    EXPECT_TRUE(made.tangent_vectors.get());
  }
  EXPECT_GT(made.effort.taylor_turns, 0);
  EXPECT_EQ(made.effort.adaptive_turns, 0);
  ASSERT_EQ(start_hybrid(test::cell_of({}).scene, {}, modes).advance({}, turn), run::Outcome::ok);
  EXPECT_EQ(turn.tangent_vectors.get(), nullptr);  // none were requested
}

TEST(HybridRunExact, SamplesPeaksAndSwitchesAreThoseOfTheAdaptiveSolver) {
  const auto scene = test::cell_of({}).scene;
  run::SolverOptions options;
  options.relative_tolerance = 1e-12;
  exact::modes::ModeCache modes;
  const auto exact = start_hybrid(scene, options, modes);
  const run::Cursor adaptive = adaptive::start_adaptive(scene, options);
  const run::TurnRequest asked{.samples_per_revolution = 64, .peaks = true, .switches = true};
  run::TurnReport a, b;
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(exact.advance(asked, a), run::Outcome::ok);
    ASSERT_EQ(adaptive(asked, b), run::Outcome::ok);
    EXPECT_EQ(a.sample_count, 64);
    EXPECT_EQ(b.sample_count, 64);
    ASSERT_EQ(a.samples.size(), b.samples.size());
    for (std::size_t i = 0; i < a.samples.size(); ++i) EXPECT_NEAR(a.samples[i], b.samples[i], 1e-9);
    EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-5 * b.peak_displacement_m);
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-5 * b.peak_contact_force_n);
    EXPECT_NEAR(a.peak_casing_displacement_m, b.peak_casing_displacement_m,
                5e-5 * b.peak_casing_displacement_m);
    EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-9);
    EXPECT_EQ(a.hits, b.hits);
    EXPECT_EQ(a.touching_at_end, b.touching_at_end);
    ASSERT_EQ(a.switches.size(), b.switches.size());
    for (std::size_t i = 0; i < a.switches.size(); ++i) {
      EXPECT_NEAR(a.switches[i].phase_rad, b.switches[i].phase_rad, 1e-9);
      EXPECT_EQ(a.switches[i].to, b.switches[i].to);
    }
  }
}

/// Observing a turn must not change the motion.
TEST(HybridRunExact, WatchingDoesNotMoveTheRotor) {
  const auto scene = test::cell_of({}).scene;
  exact::modes::ModeCache modes;
  const auto plain = start_hybrid(scene, {}, modes), watched = start_hybrid(scene, {}, modes);
  run::TurnRequest asked;
  run::TurnReport a, b;
  asked.samples_per_revolution = 128;
  asked.peaks = true;
  for (int k = 0; k < 20; ++k) {
    plain.advance({}, a);
    watched.advance(asked, b);
  }
  EXPECT_LT(difference(a, b), 1e-12);
}

/// The contact force may decrease from the first instant on, so its peak is at the start.
TEST(HybridRunExact, PeakForceOfATurnThatStartsInContact) {
  const auto scene = [] {
    auto without_kick = test::cell_of({}).scene;
    without_kick.pulses.clear();
    return without_kick;
  }();
  exact::modes::ModeCache modes;
  run::SolverOptions options;
  options.relative_tolerance = 1e-12;
  const auto exact = start_hybrid(scene, options, modes);
  options.method = run::Method::adaptive;
  const auto adaptive = start(scene, options, modes);
  run::TurnRequest asked;
  run::TurnReport a, b;
  asked.peaks = true;
  for (const double closing_speed : {-0.4, -0.1, -0.01, 0.0, 0.1}) {
    const std::vector<double> section{0, 1.02, 0, 0, 0, closing_speed, 0, 0};
    exact.restart(section);
    adaptive.restart(section);
    ASSERT_EQ(exact.advance(asked, a), run::Outcome::ok);
    ASSERT_EQ(adaptive.advance(asked, b), run::Outcome::ok);
    EXPECT_GT(b.peak_contact_force_n, 1) << closing_speed;
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-4 * b.peak_contact_force_n)
        << closing_speed;
  }
}

/// A casing that rings freely a hundred times per turn: x = (x0 cos + (v0 + z w x0) / wd sin) e^{-z w t},
/// whose maximum is at tan(wd t) = wd v0 / (w (w x0 + z v0)).
TEST(HybridRunExact, PeakOfACasingThatRings) {
  scene::Scene scene = test::cell_of({}).scene;
  scene.pulses.clear();
  const double ratio = 0.03, rate = 100 * scene.speed_rad_per_s, mass = scene.structure.mass(2, 2);
  for (const Eigen::Index k : {2, 3}) {
    scene.structure.stiffness(k, k) = mass * rate * rate;
    scene.structure.damping(k, k) = 2 * ratio * mass * rate;
  }
  // The casing starts away from the rotor and moves towards the wall.
  const double x0 = 3e-5, v0 = 0.2;
  scene.displacement_m(2) = x0;
  scene.velocity_m_per_s(2) = v0;
  const double damped = rate * std::sqrt(1 - ratio * ratio);
  const double at = std::atan2(damped * v0, rate * (rate * x0 + ratio * v0)) / damped;
  const double peak =
      std::exp(-ratio * rate * at) *
      (x0 * std::cos(damped * at) + (v0 + ratio * rate * x0) / damped * std::sin(damped * at));
  exact::modes::ModeCache modes;
  run::TurnReport turn;
  ASSERT_EQ(start_hybrid(scene, {}, modes).advance({.peaks = true}, turn), run::Outcome::ok);
  EXPECT_FALSE(turn.touched);
  EXPECT_NEAR(turn.peak_casing_displacement_m, peak, 5e-5 * peak);
  ASSERT_EQ(start_hybrid(scene, {}, modes).advance({.samples_per_revolution = 64, .peaks = true}, turn),
            run::Outcome::ok);
  EXPECT_NEAR(turn.peak_casing_displacement_m, peak, 5e-5 * peak);
}

TEST(HybridRunExact, PeaksDoNotDependOnSamples) {
  const auto scene = test::cell_of({}).scene;
  exact::modes::ModeCache modes;
  const auto bare = start_hybrid(scene, {}, modes), sampled = start_hybrid(scene, {}, modes);
  const run::TurnRequest peaks{.peaks = true}, both{.samples_per_revolution = 256, .peaks = true};
  run::TurnReport a, b;
  int touched = 0;
  for (int k = 0; k < 20; ++k) {
    bare.advance(peaks, a);
    sampled.advance(both, b);
    touched += a.touched;
    EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-5 * b.peak_displacement_m) << k;
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-6 * b.peak_contact_force_n) << k;
    EXPECT_NEAR(a.peak_casing_displacement_m, b.peak_casing_displacement_m,
                5e-5 * b.peak_casing_displacement_m)
        << k;
  }
  EXPECT_GT(touched, 5);
}

TEST(HybridRunExact, FrictionThatIsNotSaturatedGoesToTaylorPiecesAndBack) {
  test::OneSideRotor rotor;
  rotor.contact_radius_m = 1e-3;  // slip of 0.5 m/s; tanh falls where the rotor moves with the surface
  rotor.friction_steepness_s_per_m = 5;
  const auto scene = test::cell_of(rotor).scene;
  run::SolverOptions options;
  options.relative_tolerance = 1e-11;
  const run::TurnReport exact = run_exact(scene, 12, options), adaptive = run_adaptive(scene, 12, 1e-12);
  EXPECT_GT(exact.effort.taylor_turns, 2);
  EXPECT_LT(difference(exact, adaptive), 1e-7);
}

/// The casings of the two stiff stops have modes that almost cancel in the slip, so bounds on its rate are a
/// hundred times too large. The slip is far from the end of saturation, so no turn may be left to another
/// solver.
TEST(HybridRunExact, LooseBoundsOnTheSlipShortenStretchesInsteadOfGivingTheTurnUp) {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0.01;
  rotor.stiffness_n_per_m = 1.245e8;
  rotor.casing_damping_ratio = 0.05;
  rotor.casing_mass_kg = 0.05;
  rotor.casing_stiffness_n_per_m = 7.106e5;
  rotor.contact_radius_m = 0.005;
  rotor.friction_coefficient = 0.05;
  rotor.friction_steepness_s_per_m = 100;
  rotor.kick_n = 120;
  rotor.speed_hz = 143;
  rotor.whirl_ratio = 0.7;
  model::Machine machine = test::machine_of(rotor);
  machine.stops.push_back(machine.stops[0]);
  std::get<model::OneSideGeometry>(machine.stops[1].geometry).angle_deg += 180;
  const scene::Scene scene =
      scene::build_cell(machine, rotor.speed_hz, scene::WhirlRatio{rotor.whirl_ratio}).scene;
  const run::TurnReport exact = run_exact(scene, 4);
  EXPECT_GT(exact.effort.switches, 10);
  EXPECT_EQ(exact.effort.taylor_turns + exact.effort.adaptive_turns, 0);
  EXPECT_LT(difference(exact, run_adaptive(scene, 4, 1e-13)), 1e-8);
}

TEST(HybridRunExact, NearlySaturatedFrictionChangesTheSectionByTheTolerance) {
  test::OneSideRotor rotor;
  run::SolverOptions options;
  options.relative_tolerance = 1e-11;
  long fewest = 1000, most = 0;
  for (const double steepness : {0.5, 1.0, 1.5, 2.0, 3.0, 6.0, 20.0}) {
    rotor.friction_steepness_s_per_m = steepness;
    const auto scene = test::cell_of(rotor).scene;
    const run::TurnReport exact = run_exact(scene, 6, options);
    EXPECT_LT(difference(exact, run_adaptive(scene, 6, 1e-12)), 1e-8) << steepness;
    fewest = std::min(fewest, exact.effort.taylor_turns);
    most = std::max(most, exact.effort.taylor_turns);
  }
  EXPECT_EQ(fewest, 0);
  EXPECT_GT(most, 0);
}

/// The rotor bounces between undamped walls and keeps its energy.
TEST(HybridRunExact, EnergyStaysOverTenThousandTurns) {
  auto scene = test::one_mass_scene(1, 400, 0, 0.25, 1);
  scene.displacement_m << -1.5, 0.2;
  scene.contacts.push_back(test::wall_across_x(1, 1, 1e4, 0));
  scene.contacts.push_back(test::wall_across_x(-1, 1, 1e4, 0));
  const run::TurnReport turn = run_exact(scene, 10000);
  const double x = turn.section[0], y = turn.section[1], w = scene.speed_rad_per_s;
  const double beyond = std::max(0.0, std::abs(x) - 1);
  const double energy = (std::pow(w * turn.section[2], 2) + std::pow(w * turn.section[3], 2)) / 2 +
                        200 * (x * x + y * y) + 5e3 * beyond * beyond;
  EXPECT_NEAR(energy, 200 * (1.5 * 1.5 + 0.04) + 5e3 * 0.25, 1e-7);
}

/// A half subharmonic: sections an even number of turns apart agree.
TEST(HybridRunExact, APeriodicMotionStaysOnItsSectionForAHundredThousandTurns) {
  const auto scene = test::cell_of({}).scene;
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, {}, modes);
  run::TurnReport turn;
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
  const std::vector<double> early = turn.section;
  for (int k = 0; k < 100000; ++k) ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
  for (std::size_t i = 0; i < early.size(); ++i) EXPECT_NEAR(turn.section[i], early[i], 1e-12);
}

TEST(HybridRunExact, AStructureWithoutSpringsIsLeftToTaylorPieces) {
  auto scene = test::one_mass_scene(1, 0, 0, 1, 1);
  scene.velocity_m_per_s << 1, 0;
  scene.contacts.push_back(test::wall_across_x(1, 0.5, 1e3, 1));
  const run::TurnReport exact = run_exact(scene, 2), adaptive = run_adaptive(scene, 2, 1e-12);
  EXPECT_EQ(exact.effort.taylor_turns, 2);
  EXPECT_LT(difference(exact, adaptive), 1e-6);
}

TEST(HybridRunExact, PlansAreSharedOnlyWhereTheyFit) {
  exact::modes::ModeCache modes;
  test::OneSideRotor rotor;
  const auto first = test::cell_of(rotor).scene;
  const auto prepared = modes.modes_of<4>(first);
  rotor.speed_hz = 90;
  rotor.whirl_ratio = 0.2;
  EXPECT_EQ(modes.modes_of<4>(test::cell_of(rotor).scene), prepared);
  rotor.stiffness_n_per_m *= 2;
  EXPECT_NE(modes.modes_of<4>(test::cell_of(rotor).scene), prepared);
}

TEST(HybridRunExact, TooFewStepsAreSaid) {
  run::SolverOptions options;
  options.max_steps_per_revolution = 3;
  exact::modes::ModeCache modes;
  run::TurnReport turn;
  EXPECT_EQ(start_hybrid(test::cell_of({}).scene, options, modes).advance({}, turn),
            run::Outcome::step_limit);
  EXPECT_EQ(turn.effort.steps, 3);
}

/// An undamped system has no closed form during a kick of half a free period; later turns have one.
TEST(HybridRunExact, AKickAtAResonanceHasNoClosedFormWhileItLasts) {
  const auto scene =
      test::cell_of({.damping_ratio = 0, .kick_n = 20, .kick_s = 1 / 60.0, .speed_hz = 75}).scene;
  run::SolverOptions options;
  options.relative_tolerance = 1e-12;
  exact::modes::ModeCache modes;
  const run::Run exact = start_hybrid(scene, options, modes);
  const run::Cursor adaptive = adaptive::start_adaptive(scene, options);
  run::TurnReport turn, expected;
  for (int k = 0; k < 6; ++k) {
    ASSERT_EQ(exact.advance({}, turn), run::Outcome::ok);
    ASSERT_EQ(adaptive({}, expected), run::Outcome::ok);
    for (std::size_t i = 0; i < turn.section.size(); ++i)
      EXPECT_NEAR(turn.section[i], expected.section[i], 1e-8) << k << ' ' << i;
  }
  EXPECT_EQ(turn.effort.taylor_turns, 2);
}

}  // namespace
}  // namespace rubsweep::integrate
