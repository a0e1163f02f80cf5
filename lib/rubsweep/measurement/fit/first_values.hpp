#pragma once

#include <Eigen/Core>

#include "rubsweep/measurement/fit/least_squares.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"

namespace rubsweep::fit {

void begin_at(const Eigen::VectorXd& start, LeastSquares& squares);

/// Improves the start values, so that the descent does not end in a wrong minimum. Each angle is set to the
/// value with the smallest residual, the instant of the hit to the best result of many short descents.
void find_first_values(const MachineFit& problem, const LeastSquares& squares,
                       const LeastSquaresOptions& options, Eigen::VectorXd& start);

}  // namespace rubsweep::fit
