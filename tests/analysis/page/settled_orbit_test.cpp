#include "rubsweep/analysis/page/settled_orbit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::page {
namespace {

struct Recorded {
  sweep::Row row;
  std::optional<SettledOrbit> orbit;
};

Recorded record(const sweep::Study& study) {
  response::motion::Workspace workspace;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  Recorded result;
  result.row = sweep::evaluate_cell(study, prepared, 0, workspace);
  const KnownMotion known{to_string(result.row.motion_class), result.row.order, result.row.revolutions,
                          false};
  result.orbit = settled_orbit(study, prepared, 0, known, workspace);
  return result;
}

/// The trajectory of a trace with as many samples per turn as the orbit.
std::vector<trace::TracedState> trajectory(const sweep::Study& study, const SettledOrbit& orbit) {
  response::motion::Workspace workspace;
  const scene::Cell cell =
      scene::build_cell(study.machine, study.grid.speed_hz[0], scene::WhirlRatio{study.grid.unbalance[0]});
  const trace::TraceOptions options{.speed_hz = study.grid.speed_hz[0],
                                    .revolutions = orbit.first_revolution + orbit.turns,
                                    .samples_per_revolution = orbit.steps_per_turn,
                                    .window_revolutions = 1,
                                    .trajectory_revolutions = orbit.turns};
  return trace::trace_run(integrate::start(cell.scene, study.solver, workspace.modes).advance, cell.scene,
                          study.solver, options)
      .trajectory;
}

void expect_like_the_trace(const sweep::Study& study, const SettledOrbit& orbit, double tolerance_m) {
  const std::vector<trace::TracedState> traced = trajectory(study, orbit);
  ASSERT_EQ(traced.size(), static_cast<std::size_t>(orbit.turns * orbit.steps_per_turn));
  for (std::size_t i = 0; i < 5; ++i) ASSERT_EQ(orbit.signals[i].size(), traced.size() + 1);
  for (std::size_t k = 0; k < traced.size(); ++k) {
    const trace::TraceState& state = traced[k].state;
    const trace::StopState& stop = state.stops[0];
    const std::array<double, 5> expected{state.displacement_m.x(), state.displacement_m.y(),
                                         stop.casing_m.x(), stop.casing_m.y(), stop.gap_m};
    for (std::size_t i = 0; i < expected.size(); ++i)
      ASSERT_NEAR(orbit.signals[i][k], expected[i], tolerance_m) << "signal " << i << ", sample " << k;
  }
}

TEST(SettledOrbit, APeriodicMotionIsTheOneThatATraceShows) {
  // A 1/2 subharmonic of parameter set A.
  sweep::Study study = sweep::one_side_study({70}, {0.2});
  study.response.max_revolutions = 400;
  const Recorded recorded = record(study);
  ASSERT_EQ(recorded.row.motion_class, response::motion::MotionClass::subharmonic);
  ASSERT_TRUE(recorded.orbit);
  const SettledOrbit& orbit = *recorded.orbit;
  EXPECT_EQ(orbit.turns, recorded.row.order);
  EXPECT_EQ(orbit.section_m.size(), static_cast<std::size_t>(orbit.turns));
  EXPECT_GE(orbit.first_revolution, recorded.row.revolutions);
  expect_like_the_trace(study, orbit, 1e-15);
  // The orbit closes within the requested accuracy.
  for (const auto& signal : orbit.signals) EXPECT_NEAR(signal.front(), signal.back(), 1e-4 * 1e-3);
  EXPECT_NEAR(orbit.spectrum.amplitude(orbit.spectrum.turns), recorded.row.measures->amplitude_1x_forward_m,
              1e-4 * recorded.row.measures->contact.peak_displacement_m);
}

TEST(SettledOrbit, ARotorAtRestIsItsQuietWhirl) {
  const sweep::Study study = sweep::one_side_study({50}, {0.2});
  const Recorded recorded = record(study);
  ASSERT_EQ(recorded.row.motion_class, response::motion::MotionClass::non_contact);
  ASSERT_TRUE(recorded.orbit);
  const double clearance_m = study.machine.stops[0].clearance_m, radius_m = 0.2 * clearance_m;
  for (std::size_t k = 0; k < recorded.orbit->signals[0].size(); ++k) {
    EXPECT_NEAR(std::hypot(recorded.orbit->signals[0][k], recorded.orbit->signals[1][k]), radius_m, 1e-12);
    EXPECT_NEAR(recorded.orbit->signals[4][k], clearance_m - recorded.orbit->signals[1][k], 1e-12);
  }
  EXPECT_NEAR(recorded.orbit->spectrum.amplitude(1), radius_m, 1e-12);
}

TEST(SettledOrbit, AnUndecidedMotionIsTheEndOfItsRun) {
  sweep::Study study = sweep::one_side_study({75}, {0.4});
  study.response.floquet_proof = false;
  response::motion::Workspace workspace;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  const auto orbit = settled_orbit(study, prepared, 0, {"unsettled", std::nullopt, 40, false}, workspace);
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->turns, longest_aperiodic_history);
  EXPECT_EQ(orbit->first_revolution + orbit->turns, study.response.max_revolutions);
  EXPECT_EQ(orbit->section_m.size(), 2u * 12u);
  EXPECT_EQ(orbit->spectrum.turns, study.response.window_revolutions);
  expect_like_the_trace(study, *orbit, 1e-15);
}

TEST(SettledOrbit, AProvenMotionWithoutAPeriodIsLookedAtOneWindowAfterItsProof) {
  sweep::Study study = sweep::one_side_study({75}, {0.4});
  study.response.max_revolutions = 200;
  response::motion::Workspace workspace;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  const auto orbit = settled_orbit(study, prepared, 0, {"quasi_periodic", std::nullopt, 30, true}, workspace);
  ASSERT_TRUE(orbit);
  // 30 turns, a window of 12 turns, then two windows, of which the last turns are drawn.
  EXPECT_EQ(orbit->first_revolution + orbit->turns, 30 + 12 + 24);
  EXPECT_EQ(orbit->section_m.size(), 24u);
  expect_like_the_trace(study, *orbit, 1e-15);
}

TEST(SettledOrbit, ACellWithoutMotionHasNone) {
  const sweep::Study study = sweep::one_side_study({75}, {0.4});
  response::motion::Workspace workspace;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  EXPECT_FALSE(settled_orbit(study, prepared, 0, {"failed", std::nullopt, 7, false}, workspace));
  EXPECT_FALSE(settled_orbit(study, prepared, 0, {"initial_contact", std::nullopt, 0, false}, workspace));
}

}  // namespace
}  // namespace rubsweep::page
