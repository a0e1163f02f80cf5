#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::spectral {

/// Singular value decomposition a = u diag(values) v^T of a square matrix (JacobiSVD), largest value first.
/// Here so that Eigen's templates are compiled once.
struct SingularValues {
  Eigen::MatrixXd u, v;
  Eigen::VectorXd values;
};
SingularValues singular_values(const Eigen::MatrixXd& a);

}  // namespace rubsweep::numerics::spectral
