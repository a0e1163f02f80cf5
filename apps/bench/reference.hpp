#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

/// Section against which errors are measured. It is computed in long double where LongDoubleRun applies and
/// the structure is small enough. Otherwise it comes from the exact solver, and its error is estimated by its
/// distances from two other solvers in double.
struct Reference {
  std::vector<double> section;  ///< scaled like TurnReport::section
  bool long_double = false;
  double long_double_error =
      0;  ///< change of the long double section at 100 times its tolerance, plus rounding to double
  double against_rkf78 = 0;   ///< largest difference of a component from adaptive rkf78
  double against_dopri5 = 0;  ///< largest difference from adaptive dopri5, in (clearance, clearance omega)
  bool closed_forms = false;  ///< the exact solver computed no turn by a stepper or by Taylor pieces
};

/// Bound on the error of the reference; where the exact solver is the reference, the larger of its two
/// distances.
inline double uncertainty(const Reference& reference) {
  if (reference.long_double) return reference.long_double_error;
  return std::max(reference.against_rkf78, reference.against_dopri5);
}

/// Tolerance of a reference in long double, and the largest number of coordinates for which one is computed.
inline constexpr long double long_double_tolerance = 1e-17L;
inline constexpr int most_long_double_coordinates = 24;

/// Tolerance of the steppers for all other references.
inline constexpr double reference_tolerance = 1e-13;

/// Options `base` changed for references. The exact solver is used wherever it applies. Its turns without
/// closed form, and scenes to which it does not apply, are computed by rkf78 at `relative_tolerance` with
/// every contact located.
integrate::run::SolverOptions reference_options(integrate::run::SolverOptions base,
                                                double relative_tolerance = reference_tolerance);

/// Section of `scene` after `turns` revolutions. Throws ConfigError where a solver fails on the way.
Reference reference_section(const scene::Scene& scene, int turns, const integrate::run::SolverOptions& base);

/// Largest difference of a component; NaN where a component is NaN.
double section_difference(std::span<const double> a, std::span<const double> b);

}  // namespace rubsweep::bench
