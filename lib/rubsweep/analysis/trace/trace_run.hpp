#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/analysis/trace/probe.hpp"
#include "rubsweep/analysis/trace/trace_state.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::trace {

struct TraceOptions {
  double speed_hz = 0;   ///< speed of the scene as it was asked for: times come out without rounding twice
  long revolutions = 0;  ///< >= 1; the run never stops earlier but by failing
  int samples_per_revolution = 0;  ///< >= 4
  int window_revolutions = 0;      ///< >= 1: the end of the run that `last_window` may look at
  std::optional<long> trajectory_revolutions =
      std::nullopt;  ///< only so many last ones go into the trajectory; empty: all
  std::optional<Probes> probes = std::nullopt;
};

/// About how many bytes a trace and the tables made of it take in memory, changes of contact mode left out.
/// `coordinates`: of the structure.
double trace_bytes(const TraceOptions& options, std::size_t stops, Eigen::Index coordinates);

/// A state at a time since the start of the kick.
struct TracedState {
  double time_s = 0;
  TraceState state;
};

/// A change of contact mode at a time since the start of the kick.
struct TracedSwitch {
  double time_s = 0;
  integrate::run::ModeSwitch change;
};

/// One run under the lens.
struct Trace {
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  std::size_t stops = 0;
  bool twisting = false;  ///< the states have a twist and a torque
  /// Coordinates of the structure where these are more than the rotor and its casings, else 0.
  Eigen::Index vibration_coordinates = 0;
  long revolutions = 0;                 ///< whole ones; the lists go on to the failure, if there was one
  std::vector<TracedState> trajectory;  ///< samples at t = k T / N, k = 0 .. revolutions N - 1
  std::vector<TracedState> section;     ///< states at t = 0, T, 2 T, ...: one more than revolutions
  std::vector<TracedSwitch> switches;   ///< none where the law is smoothed: nothing is located then
  std::vector<response::motion::ContactFacts> turns;  ///< facts of every whole revolution
  /// Samples of the last window, or of the whole run if shorter.
  std::vector<std::complex<double>> displacement_m;
  Eigen::MatrixXd readings_m;                   ///< readings x probes, from the start through all whole turns
  std::optional<long> last_contact_revolution;  ///< 1 for the first; empty: no wall was touched
  integrate::run::Effort effort;
};

/// Runs `cursor`, a run of `scene` with `solver` at its start, for all the revolutions asked for.
Trace trace_run(const integrate::run::Cursor& cursor, const scene::Scene& scene,
                const integrate::run::SolverOptions& solver, const TraceOptions& options);

/// Contacts and full spectrum over the end of a trace.
struct TraceWindow {
  int turns = 0;  ///< 0: there was no whole revolution, and no spectrum
  response::motion::ContactFacts contact;
  response::spectrum::FullSpectrum spectrum;
};

/// The last `window_revolutions` of a trace, or all of it if shorter, cut to whole periods of a motion of
/// this `order` where at least one fits: the window whose spectrum the map takes.
TraceWindow last_window(const Trace& trace, const TraceOptions& options, std::optional<int> order,
                        response::spectrum::SpectrumWorkspace& workspace);

/// Facts of the last `turns` revolutions, all of them where there are fewer.
response::motion::ContactFacts facts_of_last(const Trace& trace, std::size_t turns);

}  // namespace rubsweep::trace
