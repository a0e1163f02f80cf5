#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::bench {

/// Section that errors are measured against. It is made in long double where LongDoubleRun applies and the
/// structure is small enough to wait for; else it is that of the exact solver, with the distances of two
/// other routes in double as the estimate of its error.
struct Reference {
  std::vector<double> section;  ///< scaled, as TurnReport::section
  bool long_double = false;
  double long_double_error =
      0;  ///< reference error: what a hundred times its tolerance changes, and rounding to double
  double against_rkf78 = 0;   ///< largest difference of a component from adaptive rkf78
  double against_dopri5 = 0;  ///< largest difference from adaptive dopri5, in (clearance, clearance omega)
  bool closed_forms = false;  ///< no turn of the exact solver was made by a stepper or by Taylor pieces
};

/// Bound on the error of the reference; where the exact solver is the reference, the larger of its two
/// distances.
inline double uncertainty(const Reference& reference) {
  if (reference.long_double) return reference.long_double_error;
  return std::max(reference.against_rkf78, reference.against_dopri5);
}

/// Tolerance of a reference in long double, and the most coordinates that one is made for.
inline constexpr long double long_double_tolerance = 1e-17L;
inline constexpr int most_long_double_coordinates = 24;

/// Tolerance of every stepper behind another reference.
inline constexpr double reference_tolerance = 1e-13;

/// `base` as references are computed: the exact solver wherever it applies, its turns without a closed form,
/// and scenes it does not take at all, by rkf78 at `relative_tolerance`, every contact located.
integrate::run::SolverOptions reference_options(integrate::run::SolverOptions base,
                                                double relative_tolerance = reference_tolerance);

/// Section of `scene` after `turns` revolutions. Throws ConfigError where a solver does not get there.
Reference reference_section(const scene::Scene& scene, int turns, const integrate::run::SolverOptions& base);

/// Largest difference of a component; NaN where one is.
double section_difference(std::span<const double> a, std::span<const double> b);

}  // namespace rubsweep::bench
