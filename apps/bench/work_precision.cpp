#include "bench/work_precision.hpp"

#include <algorithm>
#include <numeric>

#include "bench/processor_time.hpp"
#include "bench/reference.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::bench {
namespace {

/// Runs one variant once; returns the processor time in seconds.
double run_once(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                std::span<const double> reference, const WorkPrecisionOptions& options,
                integrate::exact::modes::ModeCache& modes, Measurement& measurement) {
  integrate::run::TurnReport turn;
  const double start = processor_time_s();
  const integrate::run::Run run = integrate::start(scene, solver, modes);
  for (int k = 1; k <= options.turns; ++k) {
    measurement.outcome = run.advance({}, turn);
    if (measurement.outcome != integrate::run::Outcome::ok) break;
    if (k == options.error_turns) measurement.state_error = section_difference(turn.section, reference);
  }
  const double elapsed = processor_time_s() - start;
  measurement.effort = turn.effort;
  ++measurement.repeats;
  return elapsed;
}

}  // namespace

std::vector<Measurement> measure(const scene::Scene& scene, const integrate::run::SolverOptions& base,
                                 std::span<const Variant> variants, std::span<const double> reference,
                                 const WorkPrecisionOptions& options) {
  std::vector<Measurement> measurements(variants.size());
  std::vector<std::vector<double>> seconds(variants.size());
  integrate::exact::modes::ModeCache modes;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      Measurement& measurement = measurements[i];
      measurement.variant = variants[i];
      const double used = std::accumulate(seconds[i].begin(), seconds[i].end(), 0.0);
      if (used > options.seconds_per_variant || measurement.outcome != integrate::run::Outcome::ok) continue;
      seconds[i].push_back(
          run_once(scene, options_of(variants[i], base), reference, options, modes, measurement));
    }
  }
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (measurements[i].outcome != integrate::run::Outcome::ok) continue;
    measurements[i].microseconds_per_revolution = 1e6 * median(seconds[i]) / options.turns;
  }
  return measurements;
}

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace rubsweep::bench
