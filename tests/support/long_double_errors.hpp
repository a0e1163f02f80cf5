#pragma once

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::test {

/// Errors of a run after some turns, from comparison with a run in long double (bench::LongDoubleRun).
/// Sections are scaled like those of integrate::run::TurnReport.
struct LongDoubleErrors {
  double section = 0;      ///< largest component
  double over_growth = 0;  ///< section / growth of a unit change of the start (1 or more)
  double reference = 0;    ///< change of the long double section at 100 times its tolerance
  double monodromy = 0;    ///< error of the last turn's monodromy matrix / its largest entry
  bool touched = false;
};

/// Throws std::runtime_error where a turn fails or the solver propagates no tangent vectors.
LongDoubleErrors errors_against_long_double(const scene::Scene& scene,
                                            const integrate::run::SolverOptions& solver, int turns);

}  // namespace rubsweep::test
