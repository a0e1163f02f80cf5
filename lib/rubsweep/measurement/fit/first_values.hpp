#pragma once

#include <Eigen/Core>

#include "rubsweep/measurement/fit/least_squares.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"

namespace rubsweep::fit {

void begin_at(const Eigen::VectorXd& start, LeastSquares& squares);

/// Moves first values to where a descent does not end in a wrong minimum: angles to what leaves the least,
/// the instant of the hit to where short descents from many get furthest.
void find_first_values(const MachineFit& problem, const LeastSquares& squares,
                       const LeastSquaresOptions& options, Eigen::VectorXd& start);

}  // namespace rubsweep::fit
