#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/fit/least_squares.hpp"

namespace rubsweep::fit {

/// Knowledge of the parameters near a fit: linear in the parameters, noise white and normal.
struct Uncertainty {
  double residual_rms = 0;  ///< root of the sum of squares over the degrees of freedom
  int degrees_of_freedom = 0;
  Eigen::VectorXd standard_error;  ///< infinite for what the data cannot tell
  Eigen::VectorXd half_width;      ///< half width of the 95 % interval, by Student's distribution
  Eigen::MatrixXd correlation;
  Eigen::VectorXd singular;  ///< singular values of the Jacobian with columns of length 1, largest first
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

/// Residuals of instants in a row, some at each: number k of row j is residual begin + j instants + k.
struct RowsInTime {
  Eigen::Index begin = 0, instants = 0, rows = 1;
};

/// Instants in a block beyond which residuals hardly hang together: Andrews' rule for the correlation of
/// neighbours (Econometrica 59 (1991) 817), 4 at least and a tenth of all at most.
Eigen::Index block_length(const Eigen::VectorXd& residuals, const RowsInTime& in_time);

/// Makes standard errors, and half widths of intervals, as wide as they are where residuals of an instant and
/// those of its neighbours hang together, or are larger here than there: by what the fit, linear in the
/// parameters, does without each block of instants (delete-a-group jackknife; Kuensch, Ann. Statist. 17
/// (1989) 1217). Student's distribution has as many degrees of freedom as blocks that count, for each
/// parameter by Satterthwaite's rule. What is wider for white noise stays. Rows of fewer than 24 instants,
/// and residuals outside `in_time`, count as white noise.
void allow_for_correlation(const LeastSquaresFit& fit, const std::vector<RowsInTime>& in_time,
                           Uncertainty& uncertainty);

/// Whether residuals in a row, such as samples in time, are noise.
struct ResidualTest {
  bool white = true;
  double portmanteau =
      0;  ///< Ljung and Box's sum over eight lags; noise stays below 20.09 in 99 of 100 cases
  double first_correlation = 0;  ///< correlation of neighbours, -1..1
  /// Largest line of the periodogram in cycles per residual, and its share of the sum of squares; noise makes
  /// one as large in a smaller share of cases than `level` where `line_stands_out` (Fisher's test).
  double line = 0, line_share = 0;
  bool line_stands_out = false;
};

/// Fewer than 24 residuals are white: nothing can be said. `level`: share of noises that are taken for no
/// noise, by either test.
ResidualTest test_residuals(std::span<const double> residuals, double level = 0.01);

}  // namespace rubsweep::fit
