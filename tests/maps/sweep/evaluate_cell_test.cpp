#include "rubsweep/maps/sweep/evaluate_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

#include "core/scene/table_machine.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "support/one_side_equations.hpp"

namespace rubsweep::sweep {
namespace {

Row evaluate(const Study& study, std::size_t cell = 0) {
  response::motion::Workspace workspace;
  return evaluate_cell(study, cell, workspace);
}

TEST(EvaluateCellRowOf, NothingThatIsNotFiniteIsOk) {
  const Study study = one_side_study({75}, {0.4});
  const scene::Cell cell = scene::build_cell(study.machine, 75, scene::WhirlRatio{0.4});
  response::SettledRun run;
  run.revolutions = 130;
  run.motion.motion_class = response::motion::MotionClass::synchronous;
  run.motion.order = 1;
  run.motion.measures.contact.peak_displacement_m = 1e-3;
  EXPECT_EQ(row_of(cell, 75, study.machine, &run).status, "ok");
  for (const double none : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    run.motion.measures.contact.peak_contact_force_n = none;
    const Row row = row_of(cell, 75, study.machine, &run);
    EXPECT_EQ(row.status, "non_finite");
    EXPECT_EQ(row.motion_class, response::motion::MotionClass::failed);
    EXPECT_FALSE(row.measures);
    EXPECT_FALSE(row.order);
  }
  // A finite peak divided by an extremely small clearance.
  run.motion.measures.contact.peak_contact_force_n = 1;
  scene::Cell narrow = cell;
  narrow.scene.length_scale_m = 1e-320;
  EXPECT_EQ(row_of(narrow, 75, study.machine, &run).status, "non_finite");
}

TEST(EvaluateCell, AtTheSpeedsOfATableIsTheRowOfTheNumbersTypedIn) {
  Study study = one_side_study({40, 55, 80}, {0.3, 0.7});
  study.machine = scene::table_machine();
  for (std::size_t cell = 0; cell < 6; ++cell) {
    const double speed_hz = place_of(study.grid, cell).speed_hz;
    const std::size_t row = speed_hz == 40 ? 1 : speed_hz == 55 ? 2 : 3;
    Study typed = study;
    typed.machine = scene::typed_machine(row);
    EXPECT_EQ(report::map_line(evaluate(study, cell), study), report::map_line(evaluate(typed, cell), typed))
        << cell;
  }
}

TEST(EvaluateCell, SupportsThatDoNotHoldAtASpeedAreNotAllowed) {
  Study study = one_side_study({40, 120}, {0.3});
  study.machine = scene::table_machine();
  for (model::Support& support : model::kit_of(study.machine)->supports)
    support.table->columns[0].back() = -1;
  EXPECT_EQ(evaluate(study, 0).status, "ok");
  EXPECT_EQ(evaluate(study, 1).status, "not_allowed");
}

TEST(EvaluateCellRowOf, SaysThatTheRunEndedBeforeItsKick) {
  const Study study = one_side_study({75}, {0.4});
  scene::Cell cell = scene::build_cell(study.machine, 75, scene::WhirlRatio{0.4});
  ASSERT_EQ(cell.scene.pulses.size(), 1u);
  response::SettledRun run;
  run.revolutions = 130;
  cell.scene.pulses[0].duration_s = 129.0 / 75;
  EXPECT_EQ(row_of(cell, 75, study.machine, &run).status, "ok");
  cell.scene.pulses[0].duration_s = 131.0 / 75;
  EXPECT_EQ(row_of(cell, 75, study.machine, &run).status, "kick_unfinished");
}

/// Independent model of the one-side rotor: hand-written equations and the classical Runge-Kutta method in
/// small equal steps, across all corners of the force.
class ByHand {
 public:
  using State = test::OneSideState<double>;
  static constexpr int steps_per_turn = 2000;

  explicit ByHand(const test::OneSideRotor& rotor)
      : equations_(rotor), step_s_(1 / (rotor.speed_hz * steps_per_turn)), state_(equations_.start()) {}

  void advance_one_step() {
    const double t = step_s_ * static_cast<double>(steps_), h = step_s_;
    State k1, k2, k3, k4;
    equations_(state_, k1, t);
    equations_(moved(k1, h / 2), k2, t + h / 2);
    equations_(moved(k2, h / 2), k3, t + h / 2);
    equations_(moved(k3, h), k4, t + h);
    for (std::size_t i = 0; i < 8; ++i) state_[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    ++steps_;
  }

  void advance(long turns) {
    for (long i = 0; i < turns * steps_per_turn; ++i) advance_one_step();
  }

  std::complex<double> displacement_m() const { return {state_[0], state_[1]}; }
  bool touches() const { return equations_.penetration(state_) > 0; }

  double casing_m() const { return std::hypot(state_[2], state_[3]); }

  double normal_force_n() const {
    const double spring = equations_.contact_k * equations_.penetration(state_);
    const double damper = equations_.d * equations_.closing_speed(state_);
    return std::max(0.0, std::min(2 * spring, spring + damper));
  }

 private:
  State moved(const State& rate, double h) const {
    State to = state_;
    for (std::size_t i = 0; i < 8; ++i) to[i] += h * rate[i];
    return to;
  }

  test::OneSideEquations<double> equations_;
  double step_s_;
  State state_;
  long steps_ = 0;
};

TEST(EvaluateCell, SpeedRunsFastest) {
  Study study = one_side_study({50, 60, 70}, {1.1, 1.2});
  for (std::size_t cell = 0; cell < 6; ++cell) {
    const Row row = evaluate(study, cell);
    EXPECT_EQ(row.speed_hz, study.grid.speed_hz[cell % 3]);
    EXPECT_EQ(row.whirl_ratio, study.grid.unbalance[cell / 3]);
  }
}

TEST(EvaluateCell, UnbalanceByEccentricityIsTheSameCell) {
  Study study = one_side_study({50}, {0.2});
  const Row by_ratio = evaluate(study);
  study.grid.measure = UnbalanceMeasure::eccentricity_m;
  study.grid.unbalance = {by_ratio.eccentricity_m};
  const Row by_eccentricity = evaluate(study);
  EXPECT_EQ(by_eccentricity.eccentricity_m, by_ratio.eccentricity_m);
  EXPECT_NEAR(by_eccentricity.whirl_ratio, 0.2, 1e-15);
  EXPECT_EQ(by_eccentricity.last_contact_revolution, by_ratio.last_contact_revolution);
}

TEST(EvaluateCell, AboveAWhirlRatioOfOneTheRotorRubsWithoutAKick) {
  Study study = one_side_study({75}, {1.2});
  const Row row = evaluate(study);
  EXPECT_EQ(row.start, RunStart::contact);
  EXPECT_EQ(row.status, "ok");
  EXPECT_GT(row.revolutions, 0);
  EXPECT_TRUE(row.last_contact_revolution);
  EXPECT_NE(row.proof, response::motion::Proof::rest);
  // The kick has no influence.
  study.machine.kick->force_n = 1e4;
  EXPECT_EQ(report::map_line(evaluate(study)), report::map_line(row));
  study.machine.kick.reset();
  EXPECT_EQ(report::map_line(evaluate(study)), report::map_line(row));
  study.robustness = Robustness::on;
  EXPECT_FALSE(evaluate(study).robust);
}

TEST(EvaluateCell, SaysHowItStarted) {
  Study study = one_side_study({75}, {0.4});
  EXPECT_EQ(evaluate(study).start, RunStart::kick);
  study.machine.kick.reset();
  EXPECT_EQ(evaluate(study).start, RunStart::quiet);
}

/// Independent check: a kick of negligible duration gives the rotor the velocity impulse / mass.
TEST(EvaluateCell, AGivenVelocityIsAKickOfNoLength) {
  constexpr double duration_s = 1e-10;
  const Study quiet = one_side_study({75}, {0.4});
  const double quiet_m_per_s =
      scene::build_cell(quiet.machine, 75, scene::WhirlRatio{0.4}).scene.velocity_m_per_s(1);
  int rubs = 0;
  for (const double impulse_ns : {0.3, 0.45, 0.6, 0.8, 1.0, 1.3}) {
    Study kicked = quiet, started = quiet;
    kicked.machine.kick->force_n = impulse_ns * std::numbers::pi / 2 / duration_s;
    kicked.machine.kick->duration_s = duration_s;
    started.machine.kick.reset();
    started.machine.start = {.rotor = {.vy_m_per_s = quiet_m_per_s + impulse_ns / 0.8}};
    const Row by_kick = evaluate(kicked), by_start = evaluate(started);
    EXPECT_EQ(by_start.start, RunStart::state);
    EXPECT_EQ(class_and_order(by_start), class_and_order(by_kick));
    ASSERT_TRUE(by_start.measures && by_kick.measures);
    EXPECT_NEAR(by_start.measures->contact.peak_displacement_m, by_kick.measures->contact.peak_displacement_m,
                1e-8);
    if (row_of(by_start.motion_class).rubs) ++rubs;
    started.robustness = Robustness::on;
    EXPECT_FALSE(evaluate(started).robust);
  }
  EXPECT_GT(rubs, 0);
}

/// Starts inside and in front of the wall, where the quiet whirl reaches the wall. Without a given start the
/// rotor would begin at rest.
TEST(EvaluateCell, MayStartInTheWall) {
  Study study = one_side_study({75}, {1.2});
  study.machine.kick.reset();
  for (const auto method : {integrate::run::Method::exact, integrate::run::Method::adaptive}) {
    for (const double y_m : {1.1e-3, 0.9e-3}) {
      study.solver.method = method;
      study.machine.start = {.rotor = {.y_m = y_m}};
      const Row row = evaluate(study);
      EXPECT_EQ(row.start, RunStart::state);
      EXPECT_EQ(row.status, "ok");
      EXPECT_TRUE(row.last_contact_revolution);
    }
  }
}

TEST(EvaluateCell, WhatCannotBeRunIsNot) {
  Study study = one_side_study({75}, {0.5});
  study.machine.stops[0].geometry = model::OneSideGeometry{-90};
  study.machine.gravity_m_per_s2 = 1e3;  // sags beyond the stop, so no whirl ratio exists
  const Row row = evaluate(study);
  EXPECT_EQ(to_string(row.motion_class), "initial_contact");
  EXPECT_EQ(row.status, "ok");
  EXPECT_EQ(row.revolutions, 0);
  EXPECT_FALSE(row.start || row.measures || row.proof || row.order || row.last_contact_revolution);
}

TEST(EvaluateCell, UnreachableWhirlRatio) {
  Study study = one_side_study({30}, {0.5});
  std::get<model::JeffcottRotor>(study.machine.rotor).damping_ratio = 0;
  const Row row = evaluate(study);
  EXPECT_EQ(to_string(row.motion_class), "failed");
  EXPECT_EQ(row.status, "unreachable");
  EXPECT_EQ(row.whirl_ratio, 0.5);
  EXPECT_TRUE(std::isnan(row.eccentricity_m));
  EXPECT_FALSE(row.measures || row.proof || row.order || row.last_contact_revolution);
}

TEST(EvaluateCell, WithoutAKickTheQuietWhirlIsProvenAtOnce) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick.reset();
  const Row row = evaluate(study);
  EXPECT_EQ(to_string(row.motion_class), "non_contact");
  EXPECT_EQ(row.proof, response::motion::Proof::rest);
  EXPECT_EQ(row.status, "ok");
  EXPECT_EQ(row.revolutions, 1);
  EXPECT_FALSE(row.last_contact_revolution);
  EXPECT_FALSE(row.order);
  // A = e s^2 / sqrt((1 - s^2)^2 + (2 zeta s)^2) equals whirl ratio x clearance.
  const double s = 75.0 / 30;
  EXPECT_NEAR(row.eccentricity_m, 0.4e-3 * std::hypot(1 - s * s, 2 * 0.02 * s) / (s * s), 1e-17);
  ASSERT_TRUE(row.measures);
  EXPECT_NEAR(row.measures->amplitude_1x_forward_m, 0.4e-3, 1e-17);
  EXPECT_NEAR(row.measures->amplitude_1x_backward_m, 0, 1e-17);
  EXPECT_NEAR(row.measures->contact.peak_displacement_m, 0.4e-3, 1e-17);
  EXPECT_EQ(row.measures->contact.hits, 0);
  EXPECT_EQ(row.measures->contact.peak_contact_force_n, 0);
  EXPECT_EQ(row.measures->dominant.value().order, 1);
  EXPECT_EQ(row.measures->orbit, response::spectrum::OrbitKind::circle);
  EXPECT_EQ(row.measures->whirl, response::spectrum::WhirlKind::forward);
}

TEST(EvaluateCell, AKickThatMissesTheWallLeavesNoLastContact) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick->force_n = 20;
  const Row row = evaluate(study);
  EXPECT_EQ(row.proof, response::motion::Proof::rest);
  EXPECT_FALSE(row.last_contact_revolution);
}

TEST(EvaluateCell, LastContactBeforeRestIsTheLastOneEver) {
  for (const double damping_ratio : {0.05, 0.1}) {
    Study study = one_side_study({50}, {0.2});
    std::get<model::JeffcottRotor>(study.machine.rotor).damping_ratio = damping_ratio;
    const Row row = evaluate(study);
    EXPECT_EQ(to_string(row.motion_class), "non_contact");
    EXPECT_EQ(row.proof, response::motion::Proof::rest);

    test::OneSideRotor rotor;
    rotor.speed_hz = 50;
    rotor.whirl_ratio = 0.2;
    rotor.damping_ratio = damping_ratio;
    ByHand by_hand(rotor);
    long last_contact = 0;
    for (long turn = 1; turn <= 100; ++turn) {
      for (int i = 0; i < ByHand::steps_per_turn; ++i) {
        by_hand.advance_one_step();
        if (by_hand.touches()) last_contact = turn;
      }
    }
    EXPECT_EQ(row.last_contact_revolution, last_contact);
    EXPECT_GE(row.revolutions, last_contact);
    EXPECT_LT(row.revolutions, 40);
  }
}

TEST(EvaluateCell, SubharmonicRowHoldsTheNumbersOfTheMotionByHand) {
  Study study = one_side_study({75}, {0.4});
  study.response.max_revolutions = 300;
  study.response.samples_per_revolution = 128;  // with 32, orders near 32 would be aliased onto the lines
  study.response.floquet_proof = false;
  const Row row = evaluate(study);
  EXPECT_EQ(to_string(row.motion_class), "subharmonic");
  EXPECT_EQ(row.order, 2);
  EXPECT_EQ(row.proof, response::motion::Proof::observed);
  EXPECT_EQ(row.status, "ok");
  EXPECT_EQ(row.revolutions, 300);
  ASSERT_TRUE(row.measures && row.measures->dominant);

  ByHand by_hand(test::OneSideRotor{});
  by_hand.advance(298);
  const auto section = by_hand.displacement_m();
  std::complex<double> half, forward, backward;
  double peak_m = 0, peak_n = 0, casing_m = 0;
  int touching = 0, hits = 0;
  const int steps = 2 * ByHand::steps_per_turn;
  for (int i = 0; i < steps; ++i) {
    if (i == steps / 2) {
      EXPECT_GT(std::abs(by_hand.displacement_m() - section), 1e-4);
    }
    const auto z = by_hand.displacement_m();
    const double phase = 4 * std::numbers::pi * i / steps;
    half += z * std::polar(1.0 / steps, -phase / 2);
    forward += z * std::polar(1.0 / steps, -phase);
    backward += z * std::polar(1.0 / steps, phase);
    peak_m = std::max(peak_m, std::abs(z));
    casing_m = std::max(casing_m, by_hand.casing_m());
    const bool touched = by_hand.touches();
    if (touched) peak_n = std::max(peak_n, by_hand.normal_force_n());
    by_hand.advance_one_step();
    touching += touched;
    hits += !touched && by_hand.touches();
  }
  EXPECT_LT(std::abs(by_hand.displacement_m() - section), 1e-9);
  const response::motion::Measures& m = *row.measures;
  EXPECT_EQ(m.dominant->order, 0.5);
  EXPECT_NEAR(m.dominant->amplitude_m, std::abs(half), 1e-7 * std::abs(half));
  EXPECT_NEAR(m.amplitude_1x_forward_m, std::abs(forward), 1e-7 * std::abs(half));
  EXPECT_NEAR(m.amplitude_1x_backward_m, std::abs(backward), 1e-7 * std::abs(half));
  EXPECT_NEAR(m.contact.peak_displacement_m, peak_m, 1e-5 * peak_m);
  EXPECT_NEAR(m.contact.peak_contact_force_n, peak_n, 1e-4 * peak_n);
  EXPECT_NEAR(m.contact.peak_casing_displacement_m, casing_m, 1e-4 * casing_m);
  EXPECT_NEAR(row.peak_over_clearance.value(), peak_m / 1e-3, 1e-5 * peak_m / 1e-3);
  EXPECT_NEAR(m.contact.contact_fraction, 1.0 * touching / steps, 2.0 / steps);
  EXPECT_EQ(m.contact.hits * 2, hits * m.turns);
}

TEST(EvaluateCell, StepLimitIsAFailedRowWithoutMeasures) {
  Study study = one_side_study({75}, {0.4});
  study.solver.max_steps_per_revolution = 10;
  const Row row = evaluate(study);
  EXPECT_EQ(to_string(row.motion_class), "failed");
  EXPECT_EQ(row.status, "step_limit");
  EXPECT_EQ(row.revolutions, 0);
  EXPECT_FALSE(row.measures || row.proof || row.order);
}

TEST(EvaluateCell, ReversedSlipIsAStatusOfOneWayFrictionAlone) {
  Study study = one_side_study({75}, {0.4});
  auto& stop = study.machine.stops[0];
  stop.contact_radius_m = 0;  // the slip comes from rotor and casing only, and has either sign
  stop.friction = model::OneWayFriction{0.1};
  EXPECT_EQ(evaluate(study).status, "slip_reversal");
  stop.friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  EXPECT_EQ(evaluate(study).status, "ok");
  stop.friction = model::NoFriction{};
  EXPECT_EQ(evaluate(study).status, "ok");
  stop.friction = model::ConstantFriction{0.1};
  EXPECT_EQ(evaluate(study).status, "ok");
  stop.friction = model::OneWayFriction{0.1};
  stop.contact_radius_m = 0.0375;
  EXPECT_EQ(evaluate(study).status, "ok");
}

TEST(EvaluateCell, SeveralStatusesAreJoined) {
  // Some of these limits suffice for the first contacts, but not for later ones.
  Study study = one_side_study({75}, {0.4});
  study.machine.stops[0].contact_radius_m = 0;
  study.machine.stops[0].friction = model::OneWayFriction{0.1};
  int joined = 0;
  for (long limit = 10; limit < 100; limit += 2) {
    study.solver.max_steps_per_revolution = limit;
    const Row row = evaluate(study);
    if (row.status != "step_limit;slip_reversal") continue;
    ++joined;
    EXPECT_EQ(to_string(row.motion_class), "failed");
    EXPECT_FALSE(row.measures);
  }
  EXPECT_GT(joined, 0);
}

TEST(EvaluateCell, AReversalInTheFirstTurnIsNamedWhereThatFails) {
  // Starts pressed into the wall and slides backwards along it, faster than the surface moves forward.
  Study study = one_side_study({75}, {0.4});
  model::Stop& stop = study.machine.stops[0];
  stop.friction = model::OneWayFriction{0.3};
  stop.contact_radius_m = 1e-4;
  study.machine.kick.reset();
  const double slow_m_per_s = -2 * stop.contact_radius_m * 2 * std::numbers::pi * 75;
  // Tangential direction of the wall at any angle.
  const double angle = std::get<model::OneSideGeometry>(stop.geometry).angle_deg * std::numbers::pi / 180;
  study.machine.start = model::Start{.rotor = {.x_m = 1.2 * stop.clearance_m * std::cos(angle),
                                               .y_m = 1.2 * stop.clearance_m * std::sin(angle),
                                               .vx_m_per_s = -slow_m_per_s * std::sin(angle),
                                               .vy_m_per_s = slow_m_per_s * std::cos(angle)}};
  for (const auto method : {integrate::run::Method::exact, integrate::run::Method::adaptive}) {
    study.solver.method = method;
    study.solver.max_steps_per_revolution = 10;
    const Row row = evaluate(study);
    EXPECT_EQ(row.status, "step_limit;slip_reversal");
    EXPECT_EQ(row.revolutions, 0);
  }
}

TEST(EvaluateCell, DependsOnItsArgumentsAlone) {
  const Study study = one_side_study({75}, {0.4});
  Study other = study;
  other.response.samples_per_revolution = 64;
  const std::string fresh = report::map_line(evaluate(study));
  response::motion::Workspace workspace;
  evaluate_cell(other, 0, workspace);
  EXPECT_EQ(report::map_line(evaluate_cell(study, 0, workspace)), fresh);
}

/// A casing without contact hangs on its spring.
TEST(EvaluateCell, ACasingAtRestHangsByItsWeight) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick.reset();
  study.machine.gravity_m_per_s2 = 9.81;
  const Row row = evaluate(study);
  ASSERT_EQ(to_string(row.motion_class), "non_contact");
  const model::Casing& casing = study.machine.stops[0].casing.value();
  const double sag_m = casing.mass_kg * 9.81 / casing.stiffness_n_per_m;
  EXPECT_NEAR(row.measures->contact.peak_casing_displacement_m, sag_m, 1e-12 * sag_m);
}

/// The status depends on the force for which the stiffness was linearised; the stiffness itself stays the
/// same.
TEST(EvaluateCell, BeyondHertzIsAStatusOfForcesAboveTheDesignForce) {
  Study study = one_side_study({75}, {0.4});
  const double peak_n = evaluate(study).measures->contact.peak_contact_force_n;
  auto& hertz = study.machine.stops[0].hertz.emplace();
  hertz.length_m = 0.006;
  hertz.rotor = {0.005, 2.06e11, 0.3};
  hertz.casing = {0, 1.03e11, 0.34};
  hertz.casing_shape = model::HertzShape::flat;
  hertz.design_force_n = peak_n;
  EXPECT_EQ(evaluate(study).status, "ok");
  hertz.design_force_n = peak_n / 10;
  const Row row = evaluate(study);
  EXPECT_EQ(row.status, "beyond_hertz");
  EXPECT_EQ(row.measures->contact.peak_contact_force_n, peak_n);
}

/// Above the threshold 30 Hz (1 + 0.02 / 0.04) the quiet whirl is unstable, with or without a kick.
TEST(EvaluateCell, DampingThatTurnsWithTheShaftLeavesNoQuietWhirlAboveItsThreshold) {
  Study study = one_side_study({40, 50}, {0.2});
  auto& rotor = std::get<model::JeffcottRotor>(study.machine.rotor);
  rotor.damping_ratio = 0.02;
  rotor.rotating_damping_ratio = 0.04;
  study.machine.kick.reset();
  const Row below = evaluate(study, 0), above = evaluate(study, 1);
  EXPECT_EQ(to_string(below.motion_class), "non_contact");
  EXPECT_EQ(below.proof, response::motion::Proof::rest);
  EXPECT_NE(to_string(above.motion_class), "non_contact");
  EXPECT_NE(above.proof, response::motion::Proof::rest);
  study.response.max_revolutions = 130;
  study.response.exponent = false;
  const Row early = evaluate(study, 1);
  EXPECT_EQ(early.last_contact_revolution.has_value(), false) << "rounding has not grown to a contact yet";
  EXPECT_EQ(to_string(early.motion_class), "unsettled");
}

/// The circulatory stiffness is not symmetric: all solvers must agree about its effect.
TEST(EvaluateCell, SolversAgreeWithDampingThatTurns) {
  Study study = one_side_study({75, 110}, {0.4});
  auto& rotor = std::get<model::JeffcottRotor>(study.machine.rotor);
  rotor.rotating_damping_ratio = 0.004;
  study.response = {.max_revolutions = 300};
  for (const std::size_t cell : {0u, 1u}) {
    study.solver = {};
    const Row exact = evaluate(study, cell);
    study.solver.method = integrate::run::Method::adaptive;
    study.solver.relative_tolerance = 1e-11;
    const Row adaptive = evaluate(study, cell);
    EXPECT_EQ(to_string(exact.motion_class), to_string(adaptive.motion_class));
    EXPECT_EQ(exact.order, adaptive.order);
    EXPECT_NEAR(exact.measures->contact.peak_displacement_m, adaptive.measures->contact.peak_displacement_m,
                5e-6 * exact.measures->contact.peak_displacement_m);
    ASSERT_TRUE(exact.floquet_modulus && adaptive.floquet_modulus);
    EXPECT_NEAR(*exact.floquet_modulus, *adaptive.floquet_modulus, 1e-5);
  }
}

/// A rotor lies on a floor; without the floor it would sag by four clearances. Without unbalance nothing
/// moves, and the stop carries the part of the weight that the rotor's spring does not carry. With unbalance
/// the rotor moves on the floor.
TEST(EvaluateCell, ARotorThatRestsOnAStopIsCalledSo) {
  Study study = one_side_study({60}, {0});
  study.machine.kick.reset();
  study.machine.gravity_m_per_s2 = 60;
  study.machine.stops.front().geometry = model::OneSideGeometry{-90};
  study.grid.measure = UnbalanceMeasure::eccentricity_m;
  const Row row = evaluate(study);
  EXPECT_EQ(to_string(row.motion_class), "resting_contact");
  ASSERT_TRUE(row.measures);
  EXPECT_EQ(row.measures->contact.contact_fraction, 1);
  const double rotor_n_per_m = 0.8 * std::pow(2 * std::numbers::pi * 30, 2);
  const double carried_n =
      rotor_n_per_m * row.measures->contact.peak_displacement_m + row.measures->contact.peak_contact_force_n;
  EXPECT_NEAR(carried_n, 0.8 * 60, 0.1);
  study.grid.unbalance = {1e-5};
  EXPECT_EQ(to_string(evaluate(study).motion_class), "synchronous");
}

}  // namespace
}  // namespace rubsweep::sweep
