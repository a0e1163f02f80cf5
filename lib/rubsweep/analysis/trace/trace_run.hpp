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
  double speed_hz = 0;   ///< speed of the scene as it was given, so that times in s are rounded only once
  long revolutions = 0;  ///< >= 1; only a failure ends the run earlier
  int samples_per_revolution = 0;  ///< >= 4
  int window_revolutions = 0;      ///< >= 1: turns at the end of the run that `last_window` may use
  std::optional<long> trajectory_revolutions =
      std::nullopt;  ///< number of turns at the end that the trajectory contains; empty: all turns
  std::optional<Probes> probes = std::nullopt;
};

/// Approximate memory in bytes of a trace and its tables, without changes of contact mode. `coordinates`:
/// number of coordinates of the structure.
double trace_bytes(const TraceOptions& options, std::size_t stops, Eigen::Index coordinates);

/// State at a time since the start of the kick.
struct TracedState {
  double time_s = 0;
  TraceState state;
};

/// Change of contact mode at a time since the start of the kick.
struct TracedSwitch {
  double time_s = 0;
  integrate::run::ModeSwitch change;
};

/// Detailed record of one run.
struct Trace {
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  std::size_t stops = 0;
  bool twisting = false;  ///< true: the states have a twist and a torque
  /// Number of coordinates of the structure if it has more than rotor and casings, else 0.
  Eigen::Index vibration_coordinates = 0;
  long revolutions = 0;                 ///< whole revolutions; the lists also have the time up to a failure
  std::vector<TracedState> trajectory;  ///< samples at t = k T / N, k = 0 .. revolutions N - 1
  std::vector<TracedState> section;     ///< states at t = 0, T, 2 T, ...: one more than revolutions
  std::vector<TracedSwitch> switches;   ///< empty where the law is smoothed, as no changes are located then
  std::vector<response::motion::ContactFacts> turns;  ///< facts of every whole revolution
  std::vector<std::complex<double>> displacement_m;   ///< Samples of the last window, or of a shorter run.
  Eigen::MatrixXd readings;                           ///< readings x probes, over all whole turns
  std::optional<long> last_contact_revolution;        ///< counted from 1; empty: no wall was touched
  integrate::run::Effort effort;
};

/// Runs `cursor`, a run of `scene` with `solver` at its start, for all revolutions of `options`.
Trace trace_run(const integrate::run::Cursor& cursor, const scene::Scene& scene,
                const integrate::run::SolverOptions& solver, const TraceOptions& options);

/// Contact facts and full spectrum of the end of a trace.
struct TraceWindow {
  int turns = 0;  ///< 0: no whole revolution, and no spectrum
  response::motion::ContactFacts contact;
  response::spectrum::FullSpectrum spectrum;
};

/// The last `window_revolutions` of a trace, or the whole of a shorter trace. For a motion of this `order`
/// the window is cut to whole periods if at least one fits. This is the window of the map's spectrum.
TraceWindow last_window(const Trace& trace, const TraceOptions& options, std::optional<int> order,
                        response::spectrum::SpectrumWorkspace& workspace);

/// Contact facts of the last `turns` revolutions, or of all if there are fewer.
response::motion::ContactFacts facts_of_last(const Trace& trace, std::size_t turns);

}  // namespace rubsweep::trace
