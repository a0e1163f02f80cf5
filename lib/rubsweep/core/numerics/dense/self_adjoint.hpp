#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::dense {

/// Eigenvalues, smallest first, and orthonormal eigenvectors of a self-adjoint matrix
/// (SelfAdjointEigenSolver). Here so that Eigen's templates are compiled once.
template <class Matrix>
struct SelfAdjointModes {
  Eigen::VectorXd values;
  Matrix vectors;
  bool converged = false;
};
SelfAdjointModes<Eigen::MatrixXd> self_adjoint_modes(const Eigen::MatrixXd& a);

/// Eigenvalues of a symmetric matrix alone, smallest first; all NaN where the iteration does not converge.
Eigen::VectorXd self_adjoint_eigenvalues(const Eigen::MatrixXd& a);

}  // namespace rubsweep::numerics::dense
