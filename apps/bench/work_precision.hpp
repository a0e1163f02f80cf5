#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bench/variant.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

struct WorkPrecisionOptions {
  int turns = 30;                  ///< a timed run, from the kick on; at least `error_turns`
  int error_turns = 6;             ///< the state error is that of the section after these
  int repeats = 5;                 ///< timed runs of each variant, at most
  double seconds_per_variant = 2;  ///< a variant that has used more is not repeated again
};

/// Work and precision of one variant on one scene.
struct Measurement {
  Variant variant;
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  std::optional<double> microseconds_per_revolution;  ///< median of the repeats; empty when the run failed
  std::optional<double> state_error;  ///< largest component, in (clearance, clearance omega); empty when the
                                      ///< run failed before
  int repeats = 0;
  integrate::run::Effort effort;  ///< work of one run of `turns` revolutions, or up to its failure
};

/// Runs every variant on `scene`, all of them once, then all of them again, so that a slow spell of the
/// machine slows all of them. Processor time counts; that of a run includes its start, but no factorisation
/// that an earlier run left behind. `reference`: the section after `error_turns`.
std::vector<Measurement> measure(const scene::Scene& scene, const integrate::run::SolverOptions& base,
                                 std::span<const Variant> variants, std::span<const double> reference,
                                 const WorkPrecisionOptions& options);

/// Median of `values`, the mean of the two in the middle of an even number. Not of nothing.
double median(std::vector<double> values);

}  // namespace rubsweep::bench
