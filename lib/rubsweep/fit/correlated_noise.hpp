#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/fit/least_squares.hpp"
#include "rubsweep/fit/uncertainty.hpp"

namespace rubsweep::fit {

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

}  // namespace rubsweep::fit
