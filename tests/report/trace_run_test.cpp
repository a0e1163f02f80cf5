#include "rubsweep/report/trace_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <optional>

#include "batch/read_csv.hpp"
#include "batch/temporary_directory.hpp"
#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/response/classify.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::report {
namespace {

using integrate::Outcome;
using integrate::Turn;
using test::OneSideRotor;

batch::CsvTable table_of(const std::string& text) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "table.csv";
  std::ofstream(path, std::ios::binary) << text;
  return batch::read_csv(path);
}

double value(const batch::CsvTable& table, std::size_t row, std::string_view name) {
  return batch::number(table, row, batch::column(table, name));
}

Trace run(const OneSideRotor& rotor, const TraceOptions& options,
          const integrate::SolverOptions& solver = {}) {
  const scene::Cell cell = test::cell_of(rotor);
  return trace_run(integrate::start_adaptive(cell.scene, solver), cell.scene, solver, options);
}

TraceOptions options_for(const OneSideRotor& rotor, long revolutions) {
  return {.speed_hz = rotor.speed_hz,
          .revolutions = revolutions,
          .samples_per_revolution = 20,
          .window_revolutions = 6,
          .trajectory_revolutions = {}};
}

TEST(TraceRun, SectionStartsWhereTheKickDoesAndFollowsTheReference) {
  const OneSideRotor rotor;
  const Trace trace = run(rotor, options_for(rotor, 4), {.relative_tolerance = 1e-11});
  EXPECT_EQ(trace.outcome, Outcome::ok);
  EXPECT_EQ(trace.revolutions, 4);
  const batch::CsvTable section = table_of(trace.section_csv);
  ASSERT_EQ(section.rows.size(), 5u);
  // z(0) = i A, on the circle of the quiet whirl; the casing rests.
  const double whirl_m = rotor.whirl_ratio * rotor.clearance_m;
  EXPECT_NEAR(value(section, 0, "x_m"), 0, 1e-18);
  EXPECT_NEAR(value(section, 0, "y_m"), whirl_m, 1e-18);
  EXPECT_NEAR(value(section, 0, "vx_m_per_s"), -whirl_m * 2 * std::numbers::pi * rotor.speed_hz, 1e-15);
  EXPECT_NEAR(value(section, 0, "vy_m_per_s"), 0, 1e-15);
  EXPECT_EQ(value(section, 0, "casing_0_y_m"), 0);

  const auto reference = test::long_double_sections(rotor, 4);
  const std::map<std::string, std::size_t> columns{
      {"x_m", 0}, {"y_m", 1}, {"casing_0_x_m", 2}, {"casing_0_y_m", 3}, {"vx_m_per_s", 4}, {"vy_m_per_s", 5}};
  for (std::size_t r = 0; r <= 4; ++r) {
    EXPECT_EQ(value(section, r, "revolution"), static_cast<double>(r));
    for (const auto& [name, i] : columns) {
      const double expected = static_cast<double>(reference[r][i]);
      EXPECT_NEAR(value(section, r, name), expected, i < 4 ? 1e-11 : 1e-8) << name << " after " << r;
    }
  }
}

TEST(TraceRun, SamplesLieOnTheGridAndPassThroughTheSection) {
  OneSideRotor rotor;
  rotor.speed_hz = 70;  // 1/70 is no binary fraction
  const Trace trace = run(rotor, options_for(rotor, 3));
  const batch::CsvTable trajectory = table_of(trace.trajectory_csv), section = table_of(trace.section_csv);
  ASSERT_EQ(trajectory.rows.size(), 60u);
  for (std::size_t i = 0; i < trajectory.rows.size(); ++i) {
    EXPECT_DOUBLE_EQ(value(trajectory, i, "t_s"), static_cast<double>(i) / 20 / 70);
    // A velocity is the slope of its displacement: central difference over the neighbours, in free flight.
    if (i == 0 || i + 1 == trajectory.rows.size()) continue;
    const double slope = (value(trajectory, i + 1, "x_m") - value(trajectory, i - 1, "x_m")) * 70 * 20 / 2;
    EXPECT_NEAR(value(trajectory, i, "vx_m_per_s"), slope, 0.02);
    EXPECT_NEAR(value(trajectory, i, "gap_0_m"),
                rotor.clearance_m - value(trajectory, i, "y_m") + value(trajectory, i, "casing_0_y_m"),
                1e-17);
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (const char* name :
         {"t_s", "x_m", "y_m", "vx_m_per_s", "vy_m_per_s", "casing_0_x_m", "casing_0_y_m"}) {
      EXPECT_EQ(value(trajectory, 20 * r, name), value(section, r, name)) << name << " in " << r;
    }
  }
}

TEST(TraceRun, KeepsOnlyTheLastOfTheTrajectoryWhenAsked) {
  const OneSideRotor rotor;
  TraceOptions options = options_for(rotor, 5);
  const Trace all = run(rotor, options);
  options.trajectory_revolutions = 2;
  const Trace last = run(rotor, options);
  const auto body = [](const std::string& text) { return text.substr(text.find('\n') + 1); };
  EXPECT_EQ(table_of(last.trajectory_csv).rows.size(), 40u);
  EXPECT_TRUE(all.trajectory_csv.ends_with(body(last.trajectory_csv)));
  EXPECT_EQ(last.section_csv, all.section_csv);
  EXPECT_EQ(last.events_csv, all.events_csv);
}

TEST(TraceRun, TakesAboutAsMuchMemoryAsItSays) {
  const OneSideRotor rotor;
  for (const std::optional<long> kept : {std::optional<long>(), std::optional<long>(2)}) {
    TraceOptions options = options_for(rotor, 30);
    options.trajectory_revolutions = kept;
    const Trace trace = run(rotor, options);
    const auto text = static_cast<double>(trace.trajectory_csv.size() + trace.section_csv.size());
    EXPECT_GT(trace_bytes(options, 1), text);
    EXPECT_LT(trace_bytes(options, 1), 4 * text);
  }
}

TEST(TraceRun, EventsFormOneChainPerStop) {
  model::Machine machine = test::machine_of({});
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().geometry = model::OneSideGeometry{.angle_deg = -90};
  const scene::Cell cell = scene::build_cell(machine, 80, scene::WhirlRatio{0.6});
  const Trace trace =
      trace_run(integrate::start_adaptive(cell.scene, {}), cell.scene, {}, options_for({}, 40));
  const batch::CsvTable events = table_of(trace.events_csv);
  std::map<std::string, std::string> mode{{"0", "open"}, {"1", "open"}};
  std::map<std::string, int> hits;
  double time_s = 0;
  for (std::size_t i = 0; i < events.rows.size(); ++i) {
    const std::string& stop = events.rows[i].at(1);
    EXPECT_GE(value(events, i, "t_s"), time_s);
    time_s = value(events, i, "t_s");
    EXPECT_EQ(events.rows[i].at(2), mode.at(stop)) << "line " << i;
    mode[stop] = events.rows[i].at(3);
    if (events.rows[i].at(2) == "open") {
      EXPECT_EQ(mode[stop], "clamped");  // contact begins with the damper at its limit
      ++hits[stop];
    }
  }
  EXPECT_GT(hits["0"], 3);
  EXPECT_GT(hits["1"], 3);
  EXPECT_EQ(hits["0"] + hits["1"], facts_of_last(trace, 40).hits);
  EXPECT_EQ(events.rows.size(), static_cast<std::size_t>(trace.effort.switches));
}

TEST(TraceRun, EventsAreTimedInTheirRevolution) {
  const OneSideRotor rotor;
  TraceOptions options = options_for(rotor, 30);
  options.samples_per_revolution = 500;
  const Trace trace = run(rotor, options);
  const batch::CsvTable events = table_of(trace.events_csv), trajectory = table_of(trace.trajectory_csv);
  ASSERT_GT(events.rows.size(), 8u);
  // At a touch the gap closes between two neighbours of the grid.
  for (std::size_t i = 0; i < events.rows.size(); ++i) {
    if (events.rows[i].at(2) != "open") continue;
    const auto before = static_cast<std::size_t>(std::floor(value(events, i, "t_s") * rotor.speed_hz * 500));
    EXPECT_GT(value(trajectory, before, "gap_0_m"), 0) << events.rows[i].at(0);
    EXPECT_LT(value(trajectory, before + 1, "gap_0_m"), 0) << events.rows[i].at(0);
  }
}

TEST(LastWindow, HoldsTheMeasuresOfTheMap) {
  sweep::Study study;
  study.machine = test::machine_of({});
  study.grid = {.speed_hz = {75}, .measure = sweep::UnbalanceMeasure::whirl_ratio, .unbalance = {0.4}};
  study.response = {.max_revolutions = 260,
                    .samples_per_revolution = 32,
                    .window_revolutions = 13,
                    .floquet_proof = false,
                    .max_order = 4};
  study.solver.method = integrate::Method::adaptive;  // as the trace of these tests
  response::Workspace workspace;
  const sweep::Row row = sweep::evaluate_cell(study, 0, workspace);
  ASSERT_EQ(row.order, 2);

  const TraceOptions options{.speed_hz = 75,
                             .revolutions = study.response.max_revolutions,
                             .samples_per_revolution = study.response.samples_per_revolution,
                             .window_revolutions = study.response.window_revolutions,
                             .trajectory_revolutions = 1};
  const Trace trace = run({}, options);
  const TraceWindow window = last_window(trace, options, row.order, workspace.spectrum);
  EXPECT_EQ(window.turns, 12);  // whole periods of 2 in 13
  EXPECT_EQ(window.contact.hits, 6);
  EXPECT_NEAR(window.contact.contact_fraction, row.measures->contact.contact_fraction, 0.1);
  EXPECT_EQ(window.contact.peak_displacement_m, row.measures->contact.peak_displacement_m);
  EXPECT_EQ(window.contact.peak_contact_force_n, row.measures->contact.peak_contact_force_n);
  EXPECT_EQ(window.spectrum.amplitude(12), row.measures->amplitude_1x_forward_m);
  EXPECT_EQ(window.spectrum.amplitude(-12), row.measures->amplitude_1x_backward_m);
  EXPECT_EQ(window.spectrum.order(dominant_line(window.spectrum)), row.measures->dominant->order);
  EXPECT_EQ(trace.last_contact_revolution, row.last_contact_revolution);
}

TEST(LastWindow, IsTheWholeRunWhereThatIsShorter) {
  const OneSideRotor rotor;
  const TraceOptions options = options_for(rotor, 3);
  const Trace trace = run(rotor, options);
  response::SpectrumWorkspace workspace;
  EXPECT_EQ(last_window(trace, options, std::nullopt, workspace).turns, 3);
  EXPECT_EQ(last_window(trace, options, 2, workspace).turns, 2);
  EXPECT_EQ(last_window(trace, options, 5, workspace).turns, 3);  // no whole period fits
}

/// A run of a point that stands still at (1, 2) length scales for `whole` turns, then fails after `samples`
/// more.
integrate::Cursor failing_after(int whole, int samples) {
  return [whole, samples, turns = 0](Turn& turn) mutable {
    const bool fails = turns++ == whole;
    const std::vector<double> state{static_cast<double>(turns), 2, 0, 0};
    for (int k = 0; k < (fails ? samples : turn.samples_per_revolution); ++k) {
      std::copy(state.begin(), state.end(), turn.samples.begin() + 4 * k);
    }
    turn.switches = {
        {.phase_rad = 0.1, .contact = 0, .from = contact::Mode::open, .to = contact::Mode::sprung}};
    turn.hits = 1;
    turn.peak_displacement_m = turns;
    turn.touched = turns == 2;
    turn.section = state;
    return fails ? Outcome::step_limit : Outcome::ok;
  };
}

TEST(TraceRun, GoesOnToTheFailure) {
  scene::Scene scene = test::one_mass_scene(1, 1, 0, 0.1, 1e-3);
  const TraceOptions options = options_for({.speed_hz = 10}, 9);
  const Trace trace = trace_run(failing_after(3, 7), scene, {}, options);
  EXPECT_EQ(trace.outcome, Outcome::step_limit);
  EXPECT_EQ(trace.revolutions, 3);
  EXPECT_EQ(trace.turns.size(), 3u);
  EXPECT_EQ(trace.last_contact_revolution, 2);
  const batch::CsvTable trajectory = table_of(trace.trajectory_csv);
  ASSERT_EQ(trajectory.rows.size(), 3u * 20 + 7);
  EXPECT_DOUBLE_EQ(value(trajectory, 66, "t_s"), 0.3 + 0.1 * 6 / 20);
  EXPECT_EQ(value(trajectory, 66, "x_m"), 4e-3);
  EXPECT_EQ(value(trajectory, 66, "y_m"), 2e-3);
  EXPECT_EQ(table_of(trace.section_csv).rows.size(), 4u);
  const batch::CsvTable events = table_of(trace.events_csv);
  ASSERT_EQ(events.rows.size(), 4u);
  EXPECT_DOUBLE_EQ(value(events, 3, "t_s"), 0.3 + 0.1 * 0.1 / (2 * std::numbers::pi));
  // The spectrum is that of whole revolutions.
  response::SpectrumWorkspace workspace;
  const TraceWindow window = last_window(trace, options, std::nullopt, workspace);
  EXPECT_EQ(window.turns, 3);
  EXPECT_NEAR(window.spectrum.amplitude(0), std::sqrt(8) * 1e-3, 1e-15);  // at (2, 2) in the mean
  EXPECT_EQ(window.contact.hits, 3);
  EXPECT_EQ(facts_of_last(trace, 2).peak_displacement_m, 3);
  EXPECT_EQ(facts_of_last(trace, 2).hits, 2);
}

TEST(TraceRun, ThatFailsAtOnceHasItsStartOnly) {
  scene::Scene scene = test::one_mass_scene(1, 1, 0, 0.1, 1e-3);
  const TraceOptions options = options_for({.speed_hz = 10}, 9);
  const Trace trace = trace_run(failing_after(0, 0), scene, {}, options);
  EXPECT_EQ(table_of(trace.section_csv).rows.size(), 1u);
  EXPECT_EQ(table_of(trace.trajectory_csv).rows.size(), 0u);
  response::SpectrumWorkspace workspace;
  const TraceWindow window = last_window(trace, options, 1, workspace);
  EXPECT_EQ(window.turns, 0);
  EXPECT_TRUE(window.spectrum.amplitude_m.empty());
}

}  // namespace
}  // namespace rubsweep::report
