#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/fit/least_squares.hpp"

namespace rubsweep::fit {

/// Uncertainty of the parameters near a fit, for a linear model with white normal noise.
struct Uncertainty {
  double residual_rms = 0;  ///< root of (sum of squares / degrees of freedom)
  int degrees_of_freedom = 0;
  Eigen::VectorXd standard_error;  ///< infinite where the data do not determine the parameter
  Eigen::VectorXd half_width;      ///< half width of the 95 % interval, by Student's distribution
  Eigen::MatrixXd correlation;
  Eigen::VectorXd singular;  ///< singular values of the Jacobian with normalised columns, largest first
  Eigen::MatrixXd
      /// column k: direction of singular value k, as parameters scaled by the lengths of their columns
      direction;
};

/// `eliminated`: number of further unknowns, such as offsets, that were eliminated at every step. Throws
/// ConfigError with fewer data than unknowns.
Uncertainty uncertainty_of(const LeastSquaresFit& fit, int eliminated);

/// Singular values of normalised columns below this limit belong to combinations that the data do not
/// determine.
inline constexpr double untold = 1e-3;

/// Sentences about parameters whose standard error exceeds the distance of their bounds, and about
/// combinations that the data do not determine: "a and b only together: ...". Empty where the data determine
/// all parameters.
std::vector<std::string> untold_combinations(const Uncertainty& uncertainty,
                                             const std::vector<Parameter>& parameters);

/// Residuals at consecutive instants, `rows` at each: residual k of row j has the index begin + j instants +
/// k.
struct RowsInTime {
  Eigen::Index begin = 0, instants = 0, rows = 1;
};

/// Number of instants in a block, so that residuals of different blocks are hardly correlated: Andrews' rule
/// for the correlation of neighbours (Econometrica 59 (1991) 817), at least 4 and at most a tenth of all
/// instants.
Eigen::Index block_length(const Eigen::VectorXd& residuals, const RowsInTime& in_time);

/// Widens standard errors and confidence intervals where neighbouring residuals are correlated or their size
/// varies. The errors come from the changes of the linearised fit when one block of instants after another is
/// left out (delete-a-group jackknife; Kuensch, Ann. Statist. 17 (1989) 1217). For each parameter, the
/// degrees of freedom of Student's distribution are the number of effective blocks (Satterthwaite's rule).
/// Errors never become smaller than for white noise. Rows of fewer than 24 instants, and residuals outside
/// `in_time`, count as white noise.
void allow_for_correlation(const LeastSquaresFit& fit, const std::vector<RowsInTime>& in_time,
                           Uncertainty& uncertainty);

/// Test whether consecutive residuals, such as samples in time, are white noise.
struct ResidualTest {
  bool white = true;
  double portmanteau = 0;        ///< Ljung-Box statistic over eight lags; below 20.09 for 99 % of white noise
  double first_correlation = 0;  ///< correlation of neighbours, from -1 to 1
  /// Frequency of the largest line of the periodogram, in cycles per residual, and the line's share of the
  /// sum of squares. `line_stands_out`: white noise would give such a line with a probability below `level`
  /// (Fisher's test).
  double line = 0, line_share = 0;
  bool line_stands_out = false;
};

/// Fewer than 24 residuals count as white, because they are too few for a test. `level`: share of white
/// series that each test wrongly rejects.
ResidualTest test_residuals(std::span<const double> residuals, double level = 0.01);

}  // namespace rubsweep::fit
