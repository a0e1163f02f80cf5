#include "rubsweep/analysis/line/follow_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "analysis/line/line_of_cells.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::line {
namespace {

/// The same cell as a trace of all its revolutions.
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
  // A periodic motion visits the same points, whichever turn is the first one.
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

TEST(FollowLineSettledMotion, OfASubharmonicIsThatOfALongTrace) {
  expect_as_traced(90, 0.6, 2);
  expect_as_traced(70, 0.2, 2);
}

/// The motion after a kick at this phase.
SettledMotion after_kick_at(double phase_deg, double speed_hz, double whirl_ratio) {
  model::Machine machine = scene::one_side_machine();
  machine.kick.value().phase_deg = phase_deg;
  const auto points = followed(over_speed(machine, {speed_hz}, scene::WhirlRatio{whirl_ratio}), {Pass::kick});
  return points.front().motion.value();
}

TEST(FollowLineSettledMotion, TheSectionDoesNotMoveWithThePhaseOfTheKick) {
  for (const auto& [speed_hz, whirl_ratio, turns] :
       {std::tuple(90.0, 0.6, 2U), std::tuple(50.0, 0.2, 1U), std::tuple(70.0, 0.2, 2U)}) {
    const SettledMotion at_once = after_kick_at(0, speed_hz, whirl_ratio);
    ASSERT_EQ(at_once.section.size(), turns);
    for (const double phase_deg : {40.0, 123.4, -77.0, 359.999, 720.0}) {
      const SettledMotion later = after_kick_at(phase_deg, speed_hz, whirl_ratio);
      if (later.section.size() != turns) continue;  // this kick led to another motion
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

TEST(FollowLineSettledMotion, OfARotorAtRestIsItsQuietWhirl) {
  const auto cells = over_speed(scene::one_side_machine(), {50}, scene::WhirlRatio{0.2});
  const auto points = followed(cells, {Pass::kick});
  ASSERT_TRUE(points.front().motion);
  const SettledMotion& motion = *points.front().motion;
  ASSERT_EQ(motion.section.size(), 1u);
  // At the phase of the smallest gap the rotor is closest to the wall, displaced by a fifth of the clearance,
  // and moves along the wall.
  EXPECT_NEAR(motion.section.front().displacement_m.y(), 0.2e-3, 1e-12);
  EXPECT_NEAR(motion.section.front().displacement_m.x(), 0, 1e-12);
  EXPECT_NEAR(motion.section.front().velocity_m_per_s.x(), -0.2e-3 * 2 * std::numbers::pi * 50, 1e-9);
  EXPECT_NEAR(motion.spectrum.amplitude(1), 0.2e-3, 1e-12);
  EXPECT_NEAR(motion.spectrum.amplitude(-1), 0, 1e-12);
}

TEST(FollowLineSettledMotion, WithoutAPeriodHasTwoWindows) {
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

using response::motion::MotionClass;

constexpr double damping = 0.05, stiffness_ratio = 4, eccentricity = 0.2;  // lengths in clearances

/// A rotor inside an elastic ring without friction and damping.
model::Machine ring_machine() {
  model::Machine machine = scene::one_side_machine();
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = damping};
  machine.kick.reset();
  model::Stop& stop = machine.stops.front();
  stop.geometry = model::AnnularGeometry{};
  stop.stiffness_n_per_m = stiffness_ratio * 0.8 * std::pow(2 * std::numbers::pi * 30, 2);
  stop.damping = model::ExplicitDamping{0};
  stop.friction = model::NoFriction{};
  stop.casing.reset();
  return machine;
}

/// Radius of the quiet circle / clearance at W times the natural frequency.
double quiet_radius(double w) { return eccentricity * w * w / std::hypot(1 - w * w, 2 * damping * w); }

/// Residual for the radius r of a rubbing circle: [(1 - W^2 + b (1 - 1/r))^2 + (2 z W)^2] r^2 - (e W^2)^2 =
/// 0.
double circle_equation(double w, double r) {
  const double stiffness = 1 - w * w + stiffness_ratio * (1 - 1 / r);
  return (stiffness * stiffness + std::pow(2 * damping * w, 2)) * r * r - std::pow(eccentricity * w * w, 2);
}

/// Largest root above 1 of the circle equation; 0 where there is none.
double rubbing_radius(double w) {
  for (double high = 10; high > 1.001; high -= 0.001) {
    if (circle_equation(w, high - 0.001) > 0) continue;
    double low = high - 0.001;
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (circle_equation(w, middle) > 0 ? high : low) = middle;
    }
    return low;
  }
  return 0;
}

TEST(FollowLine, HysteresisInAFrictionlessRingIsThatOfItsClosedForm) {
  std::vector<double> speeds_hz;
  for (double w = 0.75; w < 1.8; w += 0.05) speeds_hz.push_back(30 * w);
  const auto cells = over_speed(ring_machine(), speeds_hz, scene::Eccentricity{eccentricity * 1e-3});
  const auto points = followed(cells, {Pass::up, Pass::down});
  ASSERT_EQ(points.size(), 2 * cells.size());
  int both = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double w = cells[i].value / 30;
    const LinePoint &up = points[i], &down = points[cells.size() + i];
    const double quiet = quiet_radius(w), rubbing = rubbing_radius(w);
    ASSERT_TRUE(up.motion && down.motion) << w;
    // On the way up the rotor keeps its motion until this ceases to exist, and likewise on the way down.
    const bool touched_before = w > 0.925;
    const double upward = touched_before ? rubbing : quiet, downward = quiet < 1 ? quiet : rubbing;
    ASSERT_EQ(up.motion->section.size(), 1u) << w;
    ASSERT_EQ(down.motion->section.size(), 1u) << w;
    EXPECT_NEAR(up.motion->section.front().displacement_m.norm(), upward * 1e-3, 1e-5 * upward * 1e-3) << w;
    EXPECT_NEAR(down.motion->section.front().displacement_m.norm(), downward * 1e-3, 1e-5 * downward * 1e-3)
        << w;
    EXPECT_EQ(up.row.motion_class == MotionClass::synchronous, touched_before) << w;
    // The whole motion is a single line, forward at 1X.
    EXPECT_NEAR(up.motion->spectrum.amplitude(up.motion->spectrum.turns), upward * 1e-3,
                1e-5 * upward * 1e-3);
    both += up.row.motion_class != down.row.motion_class;
    EXPECT_EQ(up.row.start == sweep::RunStart::handed_on, i > 0);
    EXPECT_EQ(down.row.start == sweep::RunStart::handed_on, i + 1 < cells.size());
  }
  EXPECT_GE(both, 10);
}

TEST(FollowLine, FromTheKickHasTheRowsOfAMap) {
  const auto cells = over_speed(scene::one_side_machine(), {50, 70, 90, 110}, scene::WhirlRatio{0.6});
  const auto points = followed(cells, {Pass::kick});
  ASSERT_EQ(points.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    sweep::Study study = *cells[i].study;
    study.grid = sweep::grid_of(cells[i].place);
    response::motion::Workspace workspace;
    EXPECT_EQ(report::map_line(points[i].row), report::map_line(sweep::evaluate_cell(study, 0, workspace)));
  }
}

TEST(FollowLine, DoesNotDependOnThreads) {
  const auto cells = over_speed(scene::one_side_machine(), {60, 70, 80, 90}, scene::WhirlRatio{0.6});
  const std::vector<Pass> passes{Pass::kick, Pass::up, Pass::down};
  const auto one = followed(cells, passes, 1), three = followed(cells, passes, 3);
  ASSERT_EQ(one.size(), 12u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(report::map_line(one[i].row), report::map_line(three[i].row));
    ASSERT_TRUE(one[i].motion && three[i].motion);
    EXPECT_EQ(one[i].motion->spectrum.amplitude_m, three[i].motion->spectrum.amplitude_m);
    EXPECT_EQ(one[i].motion->end.displacement_m, three[i].motion->end.displacement_m);
  }
}

TEST(FollowLine, BehindACellWithoutMotionTheNextOneIsKicked) {
  model::Machine machine = scene::one_side_machine();
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0};
  const auto points = followed(over_speed(machine, {29, 30, 31}, scene::WhirlRatio{0.2}), {Pass::up});
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[1].row.status, "unreachable");
  EXPECT_FALSE(points[1].motion);
  EXPECT_EQ(points[2].row.start, sweep::RunStart::kick);
}

TEST(FollowLine, NoStateIsHandedOnBetweenDifferentCoordinates) {
  auto cells = over_speed(scene::one_side_machine(), {50}, scene::WhirlRatio{0.2});
  const auto others = over_speed(scene::both_sides_machine(), {60}, scene::WhirlRatio{0.2});
  cells.push_back(others.front());
  EXPECT_THROW(followed(cells, {Pass::up}), ConfigError);
  EXPECT_EQ(followed(cells, {Pass::kick}).size(), 2u);
}

TEST(FollowLine, StartsNoCellOnceItIsStopped) {
  const auto cells = over_speed(scene::one_side_machine(), {50, 60, 70}, scene::WhirlRatio{0.2});
  std::atomic<bool> stop{false};
  const std::vector<Pass> passes{Pass::up};
  EXPECT_EQ(follow_line(
                cells, passes, 1, [&](LinePoint&&) { stop = true; }, stop),
            1u);
}

}  // namespace

}  // namespace rubsweep::line
