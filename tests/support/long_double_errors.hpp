#pragma once

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::test {

/// How far a run is from one in long double (bench::LongDoubleRun) after some turns. Sections are as
/// integrate::run::TurnReport has them.
struct LongDoubleErrors {
  double section = 0;  ///< largest entry
  double over_growth =
      0;  ///< the same over what the turns make of a change of the start by one, at least one
  double reference =
      0;  ///< error of the long double section itself: what a hundred times its tolerance changes
  double monodromy = 0;  ///< error of the last turn's monodromy matrix, over its largest entry
  bool touched = false;
};

/// Throws std::runtime_error where a turn fails or the solver moves no tangent vectors.
LongDoubleErrors errors_against_long_double(const scene::Scene& scene,
                                            const integrate::run::SolverOptions& solver, int turns);

}  // namespace rubsweep::test
