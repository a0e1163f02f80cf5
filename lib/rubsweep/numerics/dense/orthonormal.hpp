#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::dense {

/// First `count` columns of the orthogonal factor of householderQr, of a matrix whose size is known at run
/// time. Here so that Eigen's templates are compiled once.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& a, Eigen::Index count);

}  // namespace rubsweep::numerics::dense
