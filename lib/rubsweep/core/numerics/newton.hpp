#pragma once

#include <cmath>
#include <limits>
#include <optional>

namespace rubsweep::numerics {

/// Limits of Newton's iteration.
struct NewtonLimits {
  int iterations = 10;
  int free_iterations = 0;  ///< number of first iterations in which the error may grow
  double growth = 1;        ///< largest allowed ratio of a later error to the one before
};

/// Newton's iteration; true where it converged. `problem` holds the unknowns and has the functions:
/// - error(i, last): evaluates the map and its derivative at iteration i and returns the error; empty where
/// this fails. `last` is the error of the iteration before, infinite at first.
/// - converged(i, error, last): whether to stop.
/// - step(i): takes Newton's step; false where there is none.
template <class Problem>
bool newton(Problem& problem, const NewtonLimits& limits) {
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < limits.iterations; ++i) {
    const std::optional<double> error = problem.error(i, last);
    if (!error || !std::isfinite(*error)) return false;
    if (problem.converged(i, *error, last)) return true;
    if (i >= limits.free_iterations && *error > limits.growth * last) return false;
    last = *error;
    if (!problem.step(i)) return false;
  }
  return false;
}

}  // namespace rubsweep::numerics
