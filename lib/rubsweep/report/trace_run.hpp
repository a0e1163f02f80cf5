#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/response/full_spectrum.hpp"
#include "rubsweep/response/motion.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::report {

struct TraceOptions {
  double speed_hz = 0;   ///< of the scene, as it was asked for: times come out without rounding twice
  long revolutions = 0;  ///< >= 1; the run never stops earlier but by failing
  int samples_per_revolution = 0;              ///< >= 4
  int window_revolutions = 0;                  ///< >= 1: the end of the run that `last_window` may look at
  std::optional<long> trajectory_revolutions;  ///< only so many last ones go into the trajectory; empty: all
};

/// About how many bytes the tables of a trace take in memory while it runs, changes of contact mode left out.
double trace_bytes(const TraceOptions& options, std::size_t stops);

/// One run under the lens: the tables of trace_csv.hpp and what the summary and the spectrum need.
struct Trace {
  integrate::Outcome outcome = integrate::Outcome::ok;
  long revolutions = 0;        ///< whole ones; the tables go on to the failure, if there was one
  std::string trajectory_csv;  ///< samples at t = k T / N, k = 0 .. revolutions N - 1
  std::string section_csv;     ///< states at t = 0, T, 2 T, ...: one more than revolutions
  std::string events_csv;      ///< only a header where the law is smoothed: nothing is located then
  std::vector<response::ContactFacts> turns;  ///< one per whole revolution
  /// Samples of the last window, or of the whole run if shorter.
  std::vector<std::complex<double>> displacement_m;
  std::optional<long> last_contact_revolution;  ///< 1 for the first; empty: no wall was touched
  integrate::Effort effort;
};

/// Runs `cursor`, a run of `scene` with `solver` at its start, for all the revolutions asked for.
Trace trace_run(const integrate::Cursor& cursor, const scene::Scene& scene,
                const integrate::SolverOptions& solver, const TraceOptions& options);

/// Contacts and full spectrum over the end of a trace.
struct TraceWindow {
  int turns = 0;  ///< 0: there was no whole revolution, and no spectrum
  response::ContactFacts contact;
  response::FullSpectrum spectrum;
};

/// The last `window_revolutions` of a trace, or all of it if shorter, cut to whole periods of a motion of
/// this `order` where at least one fits: the window whose spectrum the map takes.
TraceWindow last_window(const Trace& trace, const TraceOptions& options, std::optional<int> order,
                        response::SpectrumWorkspace& workspace);

/// Facts of the last `turns` revolutions, all of them where there are fewer.
response::ContactFacts facts_of_last(const Trace& trace, std::size_t turns);

}  // namespace rubsweep::report
