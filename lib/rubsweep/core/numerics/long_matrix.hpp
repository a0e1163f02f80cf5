#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics {

/// Matrices whose results are small differences of large numbers.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

}  // namespace rubsweep::numerics
