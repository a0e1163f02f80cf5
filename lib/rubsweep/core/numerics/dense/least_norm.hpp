#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::dense {

/// The x of least norm among those of least |a x - b|, by completeOrthogonalDecomposition, of matrices whose
/// size is known at run time. Here so that Eigen's templates are compiled once.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// By real and imaginary parts, whose least squares and norm are the same.
Eigen::VectorXcd least_norm_solution(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// First `count` columns of the orthogonal factor of householderQr, of a matrix whose size is known at run
/// time. Here so that Eigen's templates are compiled once.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& a, Eigen::Index count);

}  // namespace rubsweep::numerics::dense
