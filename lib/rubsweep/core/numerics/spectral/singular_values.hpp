#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::spectral {

/// Singular value decomposition a = u diag(values) v^T (JacobiSVD), largest value first, with as many columns
/// of u and v as there are values. Here so that Eigen's templates are compiled once.
struct SingularValues {
  Eigen::MatrixXd u, v;
  Eigen::VectorXd values;
};
SingularValues singular_values(const Eigen::MatrixXd& a);

}  // namespace rubsweep::numerics::spectral
