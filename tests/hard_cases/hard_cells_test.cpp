// Hard cells from start to row: each one ends with a reliable class, or with a status that explains why there
// is none.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

Study study_of(const model::Machine& machine, double speed_hz, double whirl_ratio) {
  Study study;
  study.machine = machine;
  study.grid.speed_hz = {speed_hz};
  study.grid.unbalance = {whirl_ratio};
  study.response = {
      .max_revolutions = 60, .samples_per_revolution = 32, .window_revolutions = 24, .max_order = 6};
  return study;
}

struct Expected {
  std::string motion_class, status;
};

void expect_row(const Study& study, const Expected& expected) {
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(to_string(row.motion_class), expected.motion_class);
  EXPECT_EQ(row.status, expected.status);
}

model::Machine undamped_rotor() {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0;
  return machine;
}

TEST(HardCells, AWhirlRatioOfOneAndAboveComesToTheWallWithoutAKick) {
  for (const double whirl_ratio : {1.0 + 1e-9, 1.2, 3.0, 1e6}) {
    response::motion::Workspace workspace;
    Study study = study_of(scene::one_side_machine(), 75, whirl_ratio);
    study.response.max_revolutions = 400;  // enough to see that it does not come to rest
    const Row row = evaluate_cell(study, 0, workspace);
    EXPECT_EQ(row.start, RunStart::contact);
    EXPECT_NE(row.motion_class, response::motion::MotionClass::initial_contact) << whirl_ratio;
    EXPECT_NE(row.motion_class, response::motion::MotionClass::non_contact) << whirl_ratio;
    EXPECT_NE(row.proof, response::motion::Proof::rest) << whirl_ratio;
    EXPECT_TRUE(row.last_contact_revolution) << whirl_ratio;
  }
}

TEST(HardCells, AtAWhirlRatioOfExactlyOneRestIsNeverProven) {
  response::motion::Workspace workspace;
  Study study = study_of(scene::one_side_machine(), 75, 1);
  study.response.max_revolutions = 400;  // long enough for the initial transient to die out
  const Row row = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(row.status, "ok");
  EXPECT_NE(row.proof, response::motion::Proof::rest);
  EXPECT_NE(row.motion_class, response::motion::MotionClass::non_contact);
}

TEST(HardCells, JustBelowOneItWhirlsWithoutContactUnlessTheSolversErrorGrazes) {
  Study study = study_of(scene::one_side_machine(), 75, 1 - 1e-3);
  study.machine.kick.reset();
  expect_row(study, {"non_contact", "ok"});
  // A circle that misses the wall by much less than the tolerance cannot be distinguished from one that
  // grazes in every turn.
  study.grid.unbalance = {1 - 1e-12};
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(row.status, "ok");
  EXPECT_TRUE(row.motion_class == response::motion::MotionClass::non_contact ||
              row.motion_class == response::motion::MotionClass::synchronous);
  ASSERT_TRUE(row.measures);
  EXPECT_NEAR(row.measures->amplitude_1x_forward_m, 1e-3, 1e-9);
}

TEST(HardCells, NoUnbalanceReachesAWhirlRatioAtAnUndampedResonance) {
  expect_row(study_of(undamped_rotor(), 30, 0.5), {"failed", "unreachable"});
  expect_row(study_of(undamped_rotor(), 30, 1.5), {"failed", "unreachable"});
}

TEST(HardCells, AnUndampedRotorJustOffItsResonanceRuns) {
  response::motion::Workspace workspace;
  EXPECT_NE(evaluate_cell(study_of(undamped_rotor(), 30.0001, 1.5), 0, workspace).motion_class,
            response::motion::MotionClass::failed);
  Study study = study_of(undamped_rotor(), 30.0001, 0.5);
  study.machine.kick.reset();
  expect_row(study, {"non_contact", "ok"});
}

TEST(HardCells, ARotorThatSagsOntoItsStopHasNoWhirlRatioButAnEccentricity) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].geometry = model::OneSideGeometry{-90};
  machine.gravity_m_per_s2 = 1e3;  // the rotor sags by 28 mm
  expect_row(study_of(machine, 75, 0.1), {"initial_contact", "ok"});
  // A given eccentricity is still possible: the rotor starts on the wall and stays there.
  Study study = study_of(machine, 75, 1e-5);
  study.grid.measure = UnbalanceMeasure::eccentricity_m;
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(row.start, RunStart::contact);
  EXPECT_EQ(row.status, "ok");
  ASSERT_TRUE(row.measures);
  EXPECT_GT(row.measures->contact.contact_fraction, 0.5);
}

TEST(HardCells, WithoutUnbalanceTheKickDiesOut) {
  expect_row(study_of(scene::one_side_machine(), 75, 0), {"non_contact", "ok"});
}

model::Machine in_a_rigid_ring(const model::Friction& friction) {
  model::Machine machine = scene::one_side_machine();
  model::Stop& stop = machine.stops[0];
  stop.geometry = model::AnnularGeometry{};
  stop.casing.reset();
  stop.friction = friction;
  return machine;
}

/// One-way friction does not reverse and drives the rotor around a rigid annular stop ever faster. The run
/// ends when its numbers overflow, and reports the fault of the model.
TEST(HardCells, FrictionThatNeverReversesRunsAwayAndIsNamed) {
  Study study = study_of(in_a_rigid_ring(model::OneWayFriction{0.2}), 75, 0.1);
  study.response.max_revolutions = 600;
  expect_row(study, {"failed", "non_finite;slip_reversal"});
}

/// Dry friction also drives the rotor backwards, but not beyond rolling.
TEST(HardCells, DryWhipEndsWhereTheSlipReverses) {
  Study study = study_of(in_a_rigid_ring(model::ConstantFriction{0.2}), 75, 0.1);
  study.response.max_revolutions = 300;
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(row.status, "ok");
  ASSERT_TRUE(row.measures);
  EXPECT_GT(row.measures->contact.contact_fraction, 0.5);
  EXPECT_LT(row.peak_over_clearance, 100);
}

TEST(HardCells, ALimitOnStepsEndsWhatWouldTakeTooLong) {
  Study study = study_of(scene::one_side_machine(), 75, 0.4);
  study.solver.method = integrate::run::Method::adaptive;
  study.solver.relative_tolerance = 1e-14;
  study.solver.max_steps_per_revolution = 1000;
  expect_row(study, {"failed", "step_limit"});
}

}  // namespace
}  // namespace rubsweep::sweep
