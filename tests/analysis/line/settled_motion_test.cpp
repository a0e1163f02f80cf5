#include "rubsweep/analysis/line/settled_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "analysis/line/line_of_cells.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::line {
namespace {

/// The same cell by a trace of all its revolutions.
trace::Trace traced(const scene::Cell& cell, const sweep::Study& study, trace::TraceOptions& options) {
  options = {.speed_hz = cell.scene.speed_rad_per_s / (2 * std::numbers::pi),
             .revolutions = study.response.max_revolutions,
             .samples_per_revolution = study.response.samples_per_revolution,
             .window_revolutions = study.response.window_revolutions,
             .trajectory_revolutions = 1};
  response::motion::Workspace workspace;
  return trace::trace_run(integrate::start(cell.scene, study.solver, workspace.modes).advance, cell.scene,
                          study.solver, options);
}

void expect_as_traced(double speed_hz, double whirl_ratio, std::size_t turns) {
  const auto cells = over_speed(scene::one_side_machine(), {speed_hz}, scene::WhirlRatio{whirl_ratio});
  const auto points = followed(cells, {Pass::kick});
  ASSERT_EQ(points.size(), 1u);
  ASSERT_TRUE(points.front().motion);
  const SettledMotion& motion = *points.front().motion;
  const auto& row = points.front().row;
  ASSERT_EQ(motion.section.size(), turns);
  const scene::Cell cell =
      scene::build_cell(*cells.front().machine, speed_hz, scene::WhirlRatio{whirl_ratio});
  trace::TraceOptions options;
  const trace::Trace trace = traced(cell, *cells.front().study, options);
  // A periodic motion comes to the same points, whatever the turn at which one begins to count.
  for (const SectionPoint& point : motion.section) {
    double nearest_m = 1, nearest_m_per_s = 1;
    for (std::size_t k = trace.section.size() - turns; k < trace.section.size(); ++k) {
      const trace::TraceState& state = trace.section[k].state;
      nearest_m = std::min(nearest_m, (state.displacement_m - point.displacement_m).norm());
      nearest_m_per_s = std::min(nearest_m_per_s, (state.velocity_m_per_s - point.velocity_m_per_s).norm());
    }
    EXPECT_LT(nearest_m, 1e-4 * 1e-3);
    EXPECT_LT(nearest_m_per_s, 1e-4 * 1e-3 * cell.scene.speed_rad_per_s);
  }
  response::motion::Workspace workspace;
  const trace::TraceWindow window = trace::last_window(trace, options, row.order, workspace.spectrum);
  ASSERT_EQ(motion.spectrum.turns, window.turns);
  for (int k = -4 * window.turns; k <= 4 * window.turns; ++k)
    EXPECT_NEAR(motion.spectrum.amplitude(k), window.spectrum.amplitude(k), 1e-4 * 1e-3) << k;
}

TEST(SettledMotion, OfASubharmonicIsThatOfALongTrace) {
  expect_as_traced(90, 0.6, 2);
  expect_as_traced(70, 0.2, 2);
}

/// The motion that a kick at this phase leads to.
SettledMotion after_kick_at(double phase_deg, double speed_hz, double whirl_ratio) {
  model::Machine machine = scene::one_side_machine();
  machine.kick.value().phase_deg = phase_deg;
  const auto points = followed(over_speed(machine, {speed_hz}, scene::WhirlRatio{whirl_ratio}), {Pass::kick});
  return points.front().motion.value();
}

TEST(SettledMotion, TheSectionDoesNotMoveWithThePhaseOfTheKick) {
  for (const auto& [speed_hz, whirl_ratio, turns] :
       {std::tuple(90.0, 0.6, 2U), std::tuple(50.0, 0.2, 1U), std::tuple(70.0, 0.2, 2U)}) {
    const SettledMotion at_once = after_kick_at(0, speed_hz, whirl_ratio);
    ASSERT_EQ(at_once.section.size(), turns);
    for (const double phase_deg : {40.0, 123.4, -77.0, 359.999, 720.0}) {
      const SettledMotion later = after_kick_at(phase_deg, speed_hz, whirl_ratio);
      if (later.section.size() != turns) continue;  // another motion
      for (const SectionPoint& point : later.section) {
        double nearest_m = 1, nearest_m_per_s = 1;
        for (const SectionPoint& other : at_once.section) {
          nearest_m = std::min(nearest_m, (other.displacement_m - point.displacement_m).norm());
          nearest_m_per_s =
              std::min(nearest_m_per_s, (other.velocity_m_per_s - point.velocity_m_per_s).norm());
        }
        EXPECT_LT(nearest_m, 1e-4 * 1e-3) << phase_deg;
        EXPECT_LT(nearest_m_per_s, 1e-4 * 1e-3 * 2 * std::numbers::pi * speed_hz) << phase_deg;
      }
    }
  }
}

TEST(SettledMotion, OfARotorAtRestIsItsQuietWhirl) {
  const auto cells = over_speed(scene::one_side_machine(), {50}, scene::WhirlRatio{0.2});
  const auto points = followed(cells, {Pass::kick});
  ASSERT_TRUE(points.front().motion);
  const SettledMotion& motion = *points.front().motion;
  ASSERT_EQ(motion.section.size(), 1u);
  // At the phase of smallest gap the rotor stands at its largest excursion towards the wall, a fifth of the
  // clearance, and moves along it.
  EXPECT_NEAR(motion.section.front().displacement_m.y(), 0.2e-3, 1e-12);
  EXPECT_NEAR(motion.section.front().displacement_m.x(), 0, 1e-12);
  EXPECT_NEAR(motion.section.front().velocity_m_per_s.x(), -0.2e-3 * 2 * std::numbers::pi * 50, 1e-9);
  EXPECT_NEAR(motion.spectrum.amplitude(1), 0.2e-3, 1e-12);
  EXPECT_NEAR(motion.spectrum.amplitude(-1), 0, 1e-12);
}

TEST(SettledMotion, WithoutAPeriodHasTwoWindows) {
  // Stiff wall, strong unbalance: chaotic.
  model::Machine machine = scene::one_side_machine();
  bool found = false;
  for (double speed_hz = 70; speed_hz < 220 && !found; speed_hz += 5) {
    const auto points = followed(over_speed(machine, {speed_hz}, scene::WhirlRatio{0.95}), {Pass::kick});
    if (points.front().row.motion_class != response::motion::MotionClass::chaotic) continue;
    found = true;
    ASSERT_TRUE(points.front().motion);
    EXPECT_EQ(points.front().motion->section.size(), 128u);
    EXPECT_EQ(points.front().motion->spectrum.turns, 64);
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace rubsweep::line
