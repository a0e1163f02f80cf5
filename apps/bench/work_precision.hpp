#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bench/variant.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

struct WorkPrecisionOptions {
  int turns = 30;                  ///< turns of a timed run, from the kick on; at least `error_turns`
  int error_turns = 6;             ///< turns after which the state error is measured
  int repeats = 5;                 ///< largest number of timed runs of each variant
  double seconds_per_variant = 2;  ///< processor time after which a variant is not repeated again, s
};

/// Effort and accuracy of one variant on one scene.
struct Measurement {
  Variant variant;
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  std::optional<double> microseconds_per_revolution;  ///< median of the repeats; empty where the run failed
  std::optional<double> state_error;  ///< largest component, in (clearance, clearance omega); empty when the
                                      ///< run failed before
  int repeats = 0;
  integrate::run::Effort effort;  ///< work of one run of `turns` revolutions, or up to its failure
};

/// Runs every variant on `scene` once, then all of them again, so that a slow phase of the computer affects
/// all alike. Processor time is measured. It includes the start of a run, but not a factorisation that an
/// earlier run left in a cache. `reference`: the section after `error_turns`.
std::vector<Measurement> measure(const scene::Scene& scene, const integrate::run::SolverOptions& base,
                                 std::span<const Variant> variants, std::span<const double> reference,
                                 const WorkPrecisionOptions& options);

/// Median of `values`, which must not be empty; for an even number, the mean of the middle two.
double median(std::vector<double> values);

}  // namespace rubsweep::bench
