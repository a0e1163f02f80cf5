#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "rubsweep/fit/least_squares.hpp"

namespace rubsweep::fit {

/// Knowledge of the parameters near a fit: linear in the parameters, noise white and normal.
struct Uncertainty {
  double residual_rms = 0;  ///< root of the sum of squares over the degrees of freedom
  int degrees_of_freedom = 0;
  Eigen::VectorXd standard_error;  ///< infinite for what the data cannot tell
  Eigen::VectorXd half_width;      ///< of the 95 % interval, by Student's distribution
  Eigen::MatrixXd correlation;
  Eigen::VectorXd singular;  ///< of the Jacobian with columns of length 1, largest first
  Eigen::MatrixXd
      direction;  ///< column k belongs to value k: shares of the parameters (by their columns' length)
};

/// `eliminated`: numbers beside the parameters that were fitted at every step, such as offsets. Throws
/// ConfigError with fewer data than numbers.
Uncertainty uncertainty_of(const LeastSquaresFit& fit, int eliminated);

/// A singular value of normed columns below this belongs to a combination that the data do not tell.
inline constexpr double untold = 1e-3;

/// Sentences about parameters whose standard error exceeds the room between their bounds, and combinations
/// that data do not tell: "a and b only together: ...". Empty where all is told.
std::vector<std::string> untold_combinations(const Uncertainty& uncertainty,
                                             const std::vector<Parameter>& parameters);

}  // namespace rubsweep::fit
