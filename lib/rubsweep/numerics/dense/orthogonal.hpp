#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::dense {

/// Orthogonal decompositions of matrices whose size is known at run time. Here so that Eigen's templates are
/// compiled once.

/// The x of least norm among those of least |a x - b|, by completeOrthogonalDecomposition.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXcd least_norm_solution(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// First `count` columns of the unitary factor of householderQr.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& a, Eigen::Index count);
Eigen::MatrixXcd orthonormal_columns(const Eigen::MatrixXcd& a, Eigen::Index count);

}  // namespace rubsweep::numerics::dense
