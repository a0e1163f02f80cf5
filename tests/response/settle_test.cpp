#include "rubsweep/response/settle.hpp"

#include <gtest/gtest.h>

#include "rubsweep/integrate/adaptive.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response {
namespace {

SettledRun run(const test::OneSideRotor& rotor, const ResponseOptions& options,
               const integrate::SolverOptions& solver = {}) {
  const auto cell = test::cell_of(rotor);
  SpectrumWorkspace workspace;
  return settle(integrate::start_adaptive(cell.scene, solver), cell, options, workspace);
}

TEST(Settle, TheHalfSubharmonicOfSetA) {
  const auto settled = run({}, {});
  EXPECT_EQ(settled.motion.motion_class, MotionClass::subharmonic);
  EXPECT_EQ(settled.motion.order, 2);
  EXPECT_EQ(settled.proof, Proof::observed);
  EXPECT_EQ(settled.revolutions, 600);
  EXPECT_GE(settled.last_contact_revolution.value_or(0), 599);  // a hit in every other turn, to the end
  const Measures& measures = settled.motion.measures;
  EXPECT_EQ(measures.contact.hits, measures.turns / 2);
  EXPECT_NEAR(std::abs(measures.dominant.value().order), 0.5, 1e-12);
  // Above the wall by its penetration, on the far side free.
  EXPECT_GT(measures.contact.peak_displacement_m, 1e-3);
  EXPECT_GT(measures.contact.peak_contact_force_n, 10);
}

TEST(Settle, LabelDoesNotDependOnTheStepper) {
  for (const auto stepper : {integrate::Stepper::rkf78, integrate::Stepper::cash_karp54,
                             integrate::Stepper::bulirsch_stoer, integrate::Stepper::rosenbrock4}) {
    integrate::SolverOptions solver;
    solver.stepper = stepper;
    if (stepper == integrate::Stepper::rosenbrock4) solver.relative_tolerance = 1e-6;
    const auto settled = run({}, {}, solver);
    EXPECT_EQ(settled.motion.order, 2) << static_cast<int>(stepper);
  }
}

TEST(Settle, AWeakKickIsProvenToRestInTheClosedFormCircle) {
  test::OneSideRotor rotor;
  rotor.kick_n = 1;
  const auto settled = run(rotor, {});
  EXPECT_EQ(settled.motion.motion_class, MotionClass::non_contact);
  EXPECT_EQ(settled.proof, Proof::rest);
  EXPECT_FALSE(settled.last_contact_revolution);
  EXPECT_LT(settled.revolutions, 20);
  EXPECT_NEAR(settled.motion.measures.amplitude_1x_forward_m, rotor.whirl_ratio * rotor.clearance_m, 1e-15);
  EXPECT_EQ(settled.motion.measures.orbit, OrbitKind::circle);
  EXPECT_EQ(settled.motion.measures.whirl, WhirlKind::forward);
  EXPECT_NEAR(settled.motion.measures.contact.peak_displacement_m, rotor.whirl_ratio * rotor.clearance_m, 1e-15);
}

TEST(Settle, ProvenRestIsWhatALongRunShows) {
  // The same cell with the proof made impossible by a critical, i.e. defective, casing mode.
  test::OneSideRotor rotor;
  rotor.whirl_ratio = 0.05;
  const auto proven = run(rotor, {});
  EXPECT_EQ(proven.proof, Proof::rest);
  rotor.casing_damping_ratio = 1;
  const auto watched = run(rotor, {});
  EXPECT_EQ(watched.motion.motion_class, MotionClass::non_contact);
  EXPECT_EQ(watched.proof, Proof::observed);
  EXPECT_EQ(watched.revolutions, 600);
  EXPECT_NEAR(watched.motion.measures.amplitude_1x_forward_m, 0.05e-3, 1e-8);
}

TEST(Settle, FailuresNameTheirOutcome) {
  integrate::SolverOptions solver;
  solver.max_steps_per_revolution = 30;
  const auto settled = run({}, {}, solver);
  EXPECT_EQ(settled.motion.motion_class, MotionClass::failed);
  EXPECT_EQ(settled.outcome, integrate::Outcome::step_limit);
  EXPECT_FALSE(settled.proof);
}

TEST(Settle, ShortestRunKeepsExactlyTwoWindows) {
  ResponseOptions options;
  options.max_revolutions = 128;
  const auto settled = run({}, options);
  EXPECT_EQ(settled.revolutions, 128);
  EXPECT_NE(settled.motion.motion_class, MotionClass::failed);
}

TEST(Settle, NoUnbalanceRestsWithoutAnyLine) {
  test::OneSideRotor rotor;
  rotor.whirl_ratio = 0;
  const auto settled = run(rotor, {});
  EXPECT_EQ(settled.motion.motion_class, MotionClass::non_contact);
  EXPECT_FALSE(settled.motion.measures.dominant);
  EXPECT_EQ(settled.motion.measures.amplitude_1x_forward_m, 0);
}

}  // namespace
}  // namespace rubsweep::response
