#include "rubsweep/analysis/trace/trace_run.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <numbers>
#include <span>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"

namespace rubsweep::trace {
namespace {

/// Fills a Trace turn by turn.
class Recorder {
 public:
  Recorder(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
           const TraceOptions& options, Trace& trace)
      : reader_(scene, solver), options_(options), trace_(trace) {
    if (options.probes) {
      refinement_ = probe_refinement(options.samples_per_revolution);
      probes_.emplace(scene, options.speed_hz, *options.probes);
    }
    trace.stops = reader_.stops();
    trace.twisting = scene.twist.has_value();
    const auto casings = std::ranges::count_if(
        scene.contacts, [](const scene::Contact& contact) { return contact.casing_point.has_value(); });
    if (scene.structure.coordinates() > 2 + 2 * casings)
      trace.vibration_coordinates = scene.structure.coordinates();
    add_section(integrate::run::scaled_initial_state(scene));
  }

  /// Adds samples and events of a turn. Of a failed turn, adds only samples and events before its failure.
  void add_samples(const integrate::run::TurnReport& turn) {
    std::vector<TracedState> states;
    auto passed = turn.switches.begin();
    const auto pass_until = [&](double phase_rad) {
      for (; passed != turn.switches.end() && passed->phase_rad <= phase_rad; ++passed) reader_.pass(*passed);
    };
    for (int k = 0; k * refinement_ < turn.sample_count; ++k) {
      const auto scaled =
          std::span(turn.samples)
              .subspan(static_cast<std::size_t>(k * refinement_) * reader_.size(), reader_.size());
      if (std::any_of(scaled.begin(), scaled.end(), [](double value) { return std::isnan(value); })) break;
      pass_until(2 * std::numbers::pi * k / options_.samples_per_revolution);
      states.push_back({sample_time_s(k), reader_.read(scaled, turns_at(k))});
      const Eigen::Vector2d& z = states.back().state.displacement_m;
      trace_.displacement_m.emplace_back(z.x(), z.y());
    }
    pass_until(2 * std::numbers::pi);
    trajectory_.push_back(std::move(states));
    if (options_.trajectory_revolutions &&
        static_cast<long>(trajectory_.size()) > *options_.trajectory_revolutions) {
      trajectory_.pop_front();
    }
    for (const integrate::run::ModeSwitch& change : turn.switches) {
      const double turns =
          static_cast<double>(trace_.revolutions) + change.phase_rad / (2 * std::numbers::pi);
      trace_.switches.push_back({turns / options_.speed_hz, change});
    }
  }

  /// Adds the values that exist only at the end of a whole turn. Call it after add_samples.
  void end_turn(const integrate::run::TurnReport& turn) {
    ++trace_.revolutions;
    if (probes_) probes_->add(turn);
    trace_.turns.push_back(response::motion::facts_of(turn));
    if (turn.touched) trace_.last_contact_revolution = trace_.revolutions;
    add_section(turn.section);
    const std::size_t kept = samples_of(options_.window_revolutions);
    auto& z = trace_.displacement_m;
    if (z.size() > kept) z.erase(z.begin(), z.end() - static_cast<std::ptrdiff_t>(kept));
  }

  /// Number of samples needed in every turn.
  int samples_wanted() const { return refinement_ * options_.samples_per_revolution; }

  void finish() {
    if (probes_) trace_.readings = probes_->readings();
    // Samples of a turn that failed are left out, as they make no whole revolution.
    const long whole = std::min<long>(trace_.revolutions, options_.window_revolutions);
    trace_.displacement_m.resize(std::min(trace_.displacement_m.size(), samples_of(whole)));
    for (; !trajectory_.empty(); trajectory_.pop_front())
      std::ranges::move(trajectory_.front(), std::back_inserter(trace_.trajectory));
  }

 private:
  std::size_t samples_of(long turns) const {
    return static_cast<std::size_t>(turns) * static_cast<std::size_t>(options_.samples_per_revolution);
  }

  /// Time in s of sample k of the turn that is being added.
  double sample_time_s(int k) const {
    const long sample = trace_.revolutions * options_.samples_per_revolution + k;
    return static_cast<double>(sample) / (options_.samples_per_revolution * options_.speed_hz);
  }

  /// Time of sample k in turns of the shaft. Its integer part is exact.
  double turns_at(int k) const {
    return static_cast<double>(trace_.revolutions) + static_cast<double>(k) / options_.samples_per_revolution;
  }

  void add_section(std::span<const double> scaled) {
    trace_.section.push_back({sample_time_s(0), reader_.read(scaled, turns_at(0))});
  }

  StateReader reader_;
  const TraceOptions& options_;
  Trace& trace_;
  int refinement_ = 1;  ///< the trace keeps one of this many samples; the probes use all
  std::optional<ProbeReader> probes_;
  std::deque<std::vector<TracedState>> trajectory_;  ///< samples of each turn
};

}  // namespace

double trace_bytes(const TraceOptions& options, std::size_t stops, Eigen::Index coordinates) {
  // Largest size of a number in a table, with all digits and its comma. `copies`: a growing list or text may
  // allocate twice its contents.
  constexpr double number_bytes = 21, copies = 2;
  const double of_coordinates = 2 * static_cast<double>(coordinates);
  const double state_bytes = sizeof(TracedState) + sizeof(StopState) * static_cast<double>(stops) +
                             sizeof(double) * of_coordinates,
               section_bytes = state_bytes + number_bytes * static_cast<double>(6 + 4 * stops),
               sample_bytes =
                   state_bytes + number_bytes * (static_cast<double>(12 + 7 * stops) + of_coordinates);
  const long kept =
      std::min(options.revolutions, options.trajectory_revolutions.value_or(options.revolutions));
  double reading_bytes = 0;
  if (options.probes) {
    const double readings =
        static_cast<double>(options.revolutions) / (options.speed_hz * options.probes->sample_s);
    reading_bytes =
        copies * readings * number_bytes * static_cast<double>(4 + 2 * options.probes->rows.rows());
  }
  return reading_bytes + copies * section_bytes * static_cast<double>(options.revolutions) +
         copies * sample_bytes * static_cast<double>(kept) * options.samples_per_revolution +
         sizeof(response::motion::ContactFacts) * static_cast<double>(options.revolutions);
}

Trace trace_run(const integrate::run::Cursor& cursor, const scene::Scene& scene,
                const integrate::run::SolverOptions& solver, const TraceOptions& options) {
  Trace trace;
  Recorder recorder(scene, solver, options, trace);
  const integrate::run::TurnRequest everything{
      .samples_per_revolution = recorder.samples_wanted(), .peaks = true, .switches = true};
  integrate::run::TurnReport turn;
  while (trace.revolutions < options.revolutions) {
    trace.outcome = cursor(everything, turn);
    trace.effort = turn.effort;
    recorder.add_samples(turn);
    if (trace.outcome != integrate::run::Outcome::ok) break;
    recorder.end_turn(turn);
  }
  recorder.finish();
  return trace;
}

response::motion::ContactFacts facts_of_last(const Trace& trace, std::size_t turns) {
  return response::motion::together(std::span(trace.turns).last(std::min(turns, trace.turns.size())));
}

TraceWindow last_window(const Trace& trace, const TraceOptions& options, std::optional<int> order,
                        response::spectrum::SpectrumWorkspace& workspace) {
  TraceWindow window;
  window.turns = static_cast<int>(std::min<long>(trace.revolutions, options.window_revolutions));
  if (window.turns == 0) return window;
  if (order && *order <= window.turns) window.turns = response::motion::window_turns(window.turns, *order);
  const std::size_t samples =
      static_cast<std::size_t>(window.turns) * static_cast<std::size_t>(options.samples_per_revolution);
  window.contact = facts_of_last(trace, static_cast<std::size_t>(window.turns));
  window.spectrum = response::spectrum::full_spectrum(std::span(trace.displacement_m).last(samples),
                                                      window.turns, workspace);
  return window;
}

}  // namespace rubsweep::trace
