#include "rubsweep/analysis/trace/trace_run.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

#include "core/scene/kit_machine.hpp"
#include "maps/batch/read_csv.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::trace {
namespace {

using integrate::run::Outcome;
using integrate::run::TurnReport;
using integrate::run::TurnRequest;
using test::OneSideRotor;

Trace run(const OneSideRotor& rotor, const TraceOptions& options,
          const integrate::run::SolverOptions& solver = {}) {
  const scene::Cell cell = test::cell_of(rotor);
  return trace_run(integrate::adaptive::start_adaptive(cell.scene, solver), cell.scene, solver, options);
}

TraceOptions options_for(const OneSideRotor& rotor, long revolutions) {
  return {.speed_hz = rotor.speed_hz,
          .revolutions = revolutions,
          .samples_per_revolution = 20,
          .window_revolutions = 6,
          .trajectory_revolutions = {}};
}

void expect_equal(const TracedState& a, const TracedState& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.state.displacement_m, b.state.displacement_m);
  EXPECT_EQ(a.state.velocity_m_per_s, b.state.velocity_m_per_s);
  ASSERT_EQ(a.state.stops.size(), b.state.stops.size());
  for (std::size_t i = 0; i < a.state.stops.size(); ++i)
    EXPECT_EQ(a.state.stops[i].casing_m, b.state.stops[i].casing_m);
  EXPECT_EQ(a.state.rates_m_per_s, b.state.rates_m_per_s);
}

TEST(TraceRun, SectionStartsWhereTheKickDoesAndFollowsTheReference) {
  const OneSideRotor rotor;
  const Trace trace = run(rotor, options_for(rotor, 4), {.relative_tolerance = 1e-11});
  EXPECT_EQ(trace.outcome, Outcome::ok);
  EXPECT_EQ(trace.revolutions, 4);
  ASSERT_EQ(trace.section.size(), 5u);
  // z(0) = i A on the circle of the quiet whirl; the casing is at rest.
  const double whirl_m = rotor.whirl_ratio * rotor.clearance_m;
  const TraceState& start = trace.section[0].state;
  EXPECT_NEAR(start.displacement_m.x(), 0, 1e-18);
  EXPECT_NEAR(start.displacement_m.y(), whirl_m, 1e-18);
  EXPECT_NEAR(start.velocity_m_per_s.x(), -whirl_m * 2 * std::numbers::pi * rotor.speed_hz, 1e-15);
  EXPECT_NEAR(start.velocity_m_per_s.y(), 0, 1e-15);
  EXPECT_EQ(start.stops[0].casing_m.y(), 0);

  const auto reference = test::long_double_sections(rotor, 4);
  for (std::size_t r = 0; r <= 4; ++r) {
    const TraceState& state = trace.section[r].state;
    const std::array<double, 6> found{state.displacement_m.x(),    state.displacement_m.y(),
                                      state.stops[0].casing_m.x(), state.stops[0].casing_m.y(),
                                      state.velocity_m_per_s.x(),  state.velocity_m_per_s.y()};
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i], static_cast<double>(reference[r][i]), i < 4 ? 1e-11 : 1e-8)
          << i << " after " << r;
    }
    EXPECT_NEAR(state.stops[0].casing_m_per_s.x(), static_cast<double>(reference[r][6]), 1e-7);
    EXPECT_NEAR(state.stops[0].casing_m_per_s.y(), static_cast<double>(reference[r][7]), 1e-7);
  }
}

TEST(TraceRun, SamplesLieOnTheGridAndPassThroughTheSection) {
  OneSideRotor rotor;
  rotor.speed_hz = 70;  // 1/70 is not a binary fraction
  const Trace trace = run(rotor, options_for(rotor, 3));
  const auto& trajectory = trace.trajectory;
  ASSERT_EQ(trajectory.size(), 60u);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    EXPECT_DOUBLE_EQ(trajectory[i].time_s, static_cast<double>(i) / 20 / 70);
    // In free flight a velocity equals the central difference of the neighbouring displacements.
    if (i == 0 || i + 1 == trajectory.size()) continue;
    const TraceState &before = trajectory[i - 1].state, &state = trajectory[i].state,
                     &after = trajectory[i + 1].state;
    const double slope = (after.displacement_m.x() - before.displacement_m.x()) * 70 * 20 / 2;
    EXPECT_NEAR(state.velocity_m_per_s.x(), slope, 0.02);
    EXPECT_NEAR(state.stops[0].gap_m,
                rotor.clearance_m - state.displacement_m.y() + state.stops[0].casing_m.y(), 1e-17);
  }
  for (std::size_t r = 0; r < 3; ++r) expect_equal(trajectory[20 * r], trace.section[r]);
}

TEST(TraceRun, KeepsOnlyTheLastOfTheTrajectoryWhenAsked) {
  const OneSideRotor rotor;
  TraceOptions options = options_for(rotor, 5);
  const Trace all = run(rotor, options);
  options.trajectory_revolutions = 2;
  const Trace last = run(rotor, options);
  ASSERT_EQ(all.trajectory.size(), 100u);
  ASSERT_EQ(last.trajectory.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) expect_equal(last.trajectory[i], all.trajectory[60 + i]);
  ASSERT_EQ(last.section.size(), all.section.size());
  for (std::size_t r = 0; r < all.section.size(); ++r) expect_equal(last.section[r], all.section[r]);
  EXPECT_EQ(last.switches.size(), all.switches.size());
}

TEST(TraceRun, TakesAboutAsMuchMemoryAsItSays) {
  const OneSideRotor rotor;
  for (const std::optional<long> kept : {std::optional<long>(), std::optional<long>(2)}) {
    TraceOptions options = options_for(rotor, 30);
    options.trajectory_revolutions = kept;
    const Trace trace = run(rotor, options);
    // Size of the lists; the tables made from them take about 1.5 times as much in addition.
    const double list = (sizeof(TracedState) + sizeof(StopState) + 8 * sizeof(double)) *
                        static_cast<double>(trace.trajectory.size() + trace.section.size());
    EXPECT_GT(trace_bytes(options, 1, 4), 2 * list);
    EXPECT_LT(trace_bytes(options, 1, 4), 8 * list);
  }
}

TEST(TraceRun, EventsFormOneChainPerStop) {
  model::Machine machine = test::machine_of({});
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().geometry = model::OneSideGeometry{.angle_deg = -90};
  const scene::Cell cell = scene::build_cell(machine, 80, scene::WhirlRatio{0.6});
  const Trace trace =
      trace_run(integrate::adaptive::start_adaptive(cell.scene, {}), cell.scene, {}, options_for({}, 40));
  using contact::Mode;
  std::array<Mode, 2> mode{Mode::open, Mode::open};
  std::array<int, 2> hits{};
  double last_s = 0;
  for (const auto& [time_s, change] : trace.switches) {
    const auto stop = static_cast<std::size_t>(change.contact);
    EXPECT_GE(time_s, last_s);
    last_s = time_s;
    EXPECT_EQ(change.from, mode.at(stop)) << "at " << time_s;
    mode[stop] = change.to;
    if (change.from == Mode::open) {
      EXPECT_EQ(change.to, Mode::clamped);  // contact begins with the damper force at its limit
      ++hits[stop];
    }
  }
  EXPECT_GT(hits[0], 3);
  EXPECT_GT(hits[1], 3);
  EXPECT_EQ(hits[0] + hits[1], facts_of_last(trace, 40).hits);
  EXPECT_EQ(trace.switches.size(), static_cast<std::size_t>(trace.effort.switches));
}

TEST(TraceRun, EventsAreTimedInTheirRevolution) {
  const OneSideRotor rotor;
  TraceOptions options = options_for(rotor, 30);
  options.samples_per_revolution = 500;
  const Trace trace = run(rotor, options);
  ASSERT_GT(trace.switches.size(), 8u);
  // At a touch the gap closes between two neighbouring samples.
  for (const auto& [time_s, change] : trace.switches) {
    if (change.from != contact::Mode::open) continue;
    const auto before = static_cast<std::size_t>(std::floor(time_s * rotor.speed_hz * 500));
    EXPECT_GT(trace.trajectory[before].state.stops[0].gap_m, 0) << time_s;
    EXPECT_LT(trace.trajectory[before + 1].state.stops[0].gap_m, 0) << time_s;
  }
}

TEST(TraceRunLastWindow, HoldsTheMeasuresOfTheMap) {
  sweep::Study study;
  study.machine = test::machine_of({});
  study.grid = {.speed_hz = {75}, .measure = sweep::UnbalanceMeasure::whirl_ratio, .unbalance = {0.4}};
  study.response = {.max_revolutions = 260,
                    .samples_per_revolution = 32,
                    .window_revolutions = 13,
                    .floquet_proof = false,
                    .max_order = 4};
  study.solver.method = integrate::run::Method::adaptive;  // method of the traces in these tests
  response::motion::Workspace workspace;
  const sweep::Row row = sweep::evaluate_cell(study, 0, workspace);
  ASSERT_EQ(row.order, 2);

  const TraceOptions options{.speed_hz = 75,
                             .revolutions = study.response.max_revolutions,
                             .samples_per_revolution = study.response.samples_per_revolution,
                             .window_revolutions = study.response.window_revolutions,
                             .trajectory_revolutions = 1};
  const Trace trace = run({}, options);
  const TraceWindow window = last_window(trace, options, row.order, workspace.spectrum);
  EXPECT_EQ(window.turns, 12);  // whole periods of 2 turns within 13 turns
  EXPECT_EQ(window.contact.hits, 6);
  EXPECT_NEAR(window.contact.contact_fraction, row.measures->contact.contact_fraction, 0.1);
  EXPECT_EQ(window.contact.peak_displacement_m, row.measures->contact.peak_displacement_m);
  EXPECT_EQ(window.contact.peak_contact_force_n, row.measures->contact.peak_contact_force_n);
  EXPECT_EQ(window.spectrum.amplitude(12), row.measures->amplitude_1x_forward_m);
  EXPECT_EQ(window.spectrum.amplitude(-12), row.measures->amplitude_1x_backward_m);
  EXPECT_EQ(window.spectrum.order(dominant_line(window.spectrum)), row.measures->dominant->order);
  EXPECT_EQ(trace.last_contact_revolution, row.last_contact_revolution);
}

TEST(TraceRunLastWindow, IsTheWholeRunWhereThatIsShorter) {
  const OneSideRotor rotor;
  const TraceOptions options = options_for(rotor, 3);
  const Trace trace = run(rotor, options);
  response::spectrum::SpectrumWorkspace workspace;
  EXPECT_EQ(last_window(trace, options, std::nullopt, workspace).turns, 3);
  EXPECT_EQ(last_window(trace, options, 2, workspace).turns, 2);
  EXPECT_EQ(last_window(trace, options, 5, workspace).turns, 3);  // no whole period fits into the trace
}

/// A run of a point that rests at (1, 2) length scales for `whole` turns, and fails `samples` samples later.
integrate::run::Cursor failing_after(int whole, int samples) {
  return [whole, samples, turns = 0](const TurnRequest& asked, TurnReport& turn) mutable {
    const bool fails = turns++ == whole;
    const std::vector<double> state{static_cast<double>(turns), 2, 0, 0};
    turn.sample_count = fails ? samples : asked.samples_per_revolution;
    turn.samples.resize(static_cast<std::size_t>(4 * asked.samples_per_revolution));
    for (int k = 0; k < turn.sample_count; ++k)
      std::copy(state.begin(), state.end(), turn.samples.begin() + 4 * k);
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
  ASSERT_EQ(trace.trajectory.size(), 3u * 20 + 7);
  EXPECT_DOUBLE_EQ(trace.trajectory[66].time_s, 0.3 + 0.1 * 6 / 20);
  EXPECT_EQ(trace.trajectory[66].state.displacement_m, Eigen::Vector2d(4e-3, 2e-3));
  EXPECT_EQ(trace.section.size(), 4u);
  ASSERT_EQ(trace.switches.size(), 4u);
  EXPECT_DOUBLE_EQ(trace.switches[3].time_s, 0.3 + 0.1 * 0.1 / (2 * std::numbers::pi));
  // The spectrum uses whole revolutions only.
  response::spectrum::SpectrumWorkspace workspace;
  const TraceWindow window = last_window(trace, options, std::nullopt, workspace);
  EXPECT_EQ(window.turns, 3);
  EXPECT_NEAR(window.spectrum.amplitude(0), std::sqrt(8) * 1e-3, 1e-15);  // the mean is (2, 2)
  EXPECT_EQ(window.contact.hits, 3);
  EXPECT_EQ(facts_of_last(trace, 2).peak_displacement_m, 3);
  EXPECT_EQ(facts_of_last(trace, 2).hits, 2);
}

TEST(TraceRun, ThatFailsAtOnceHasItsStartOnly) {
  scene::Scene scene = test::one_mass_scene(1, 1, 0, 0.1, 1e-3);
  const TraceOptions options = options_for({.speed_hz = 10}, 9);
  const Trace trace = trace_run(failing_after(0, 0), scene, {}, options);
  EXPECT_EQ(trace.section.size(), 1u);
  EXPECT_TRUE(trace.trajectory.empty());
  response::spectrum::SpectrumWorkspace workspace;
  const TraceWindow window = last_window(trace, options, 1, workspace);
  EXPECT_EQ(window.turns, 0);
  EXPECT_TRUE(window.spectrum.amplitude_m.empty());
}

/// Position x + i y of a rotor that stands at rest in its unloaded position at t = 0, after each of `samples`
/// intervals: classical Runge-Kutta in small fixed steps under unbalance, weight and a kick along +y.
std::vector<std::complex<double>> from_rest(double hz, double speed_hz, const model::Kick& kick,
                                            int samples) {
  using Complex = std::complex<double>;
  constexpr double pi = std::numbers::pi, mass_kg = 0.8, zeta = 0.02, eccentricity_m = 1e-4, gravity = 9.81;
  constexpr int steps = 200;
  const double w = 2 * pi * speed_hz, w0 = 2 * pi * hz, h = 1 / (20 * speed_hz * steps);
  const auto acceleration = [&](double t, Complex z, Complex v) {
    const double force_n = t < kick.duration_s ? kick.force_n * std::sin(pi * t / kick.duration_s) : 0;
    return eccentricity_m * w * w * std::polar(1.0, w * t) + Complex(0, force_n / mass_kg - gravity) -
           2 * zeta * w0 * v - w0 * w0 * z;
  };
  std::vector<Complex> found{0};
  Complex z = 0, v = 0;
  for (int k = 0; k < samples * steps; ++k) {
    const double t = k * h;
    const Complex a1 = acceleration(t, z, v), v2 = v + h / 2 * a1,
                  a2 = acceleration(t + h / 2, z + h / 2 * v, v2), v3 = v + h / 2 * a2,
                  a3 = acceleration(t + h / 2, z + h / 2 * v2, v3), v4 = v + h * a3,
                  a4 = acceleration(t + h, z + h * v3, v4);
    z += h / 6 * (v + 2.0 * v2 + 2.0 * v3 + v4);
    v += h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    if ((k + 1) % steps == 0) found.push_back(z);
  }
  return found;
}

TEST(TraceRun, FromRestUnbalanceWeightAndKickActAtOnce) {
  for (model::Machine machine : {scene::one_side_machine(), scene::light_shaft_machine()}) {
    machine.stops[0].clearance_m = 1;
    machine.gravity_m_per_s2 = 9.81;
    machine.start = {.at_rest = true};
    const scene::PreparedMachine prepared = scene::prepare_machine(machine);
    const double hz = prepared.reduction ? prepared.reduction->frequency_hz[0](0) : 30.0;
    const scene::Cell cell = scene::build_cell(prepared, 40, scene::Eccentricity{1e-4});
    const auto expected = from_rest(hz, 40, *machine.kick, 5 * 20);
    for (const integrate::run::SolverOptions& solver :
         {integrate::run::SolverOptions{}, integrate::run::SolverOptions{.relative_tolerance = 1e-11}}) {
      integrate::exact::modes::ModeCache modes;
      const bool exact = solver.relative_tolerance != 1e-11;
      const Trace trace = trace_run(exact ? integrate::start(cell.scene, solver, modes).advance
                                          : integrate::adaptive::start_adaptive(cell.scene, solver),
                                    cell.scene, solver, options_for({.speed_hz = 40}, 5));
      ASSERT_EQ(trace.trajectory.size(), 100u);
      for (std::size_t k = 0; k < trace.trajectory.size(); ++k) {
        const Eigen::Vector2d& at = trace.trajectory[k].state.displacement_m;
        EXPECT_NEAR(std::abs(std::complex<double>(at.x(), at.y()) - expected[k]), 0, 1e-9) << k << exact;
      }
    }
  }
}

}  // namespace
}  // namespace rubsweep::trace
