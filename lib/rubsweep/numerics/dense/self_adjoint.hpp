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
SelfAdjointModes<Eigen::MatrixXcd> self_adjoint_modes(const Eigen::MatrixXcd& a);

/// Eigenvalues of a symmetric matrix alone, smallest first.
Eigen::VectorXd self_adjoint_eigenvalues(const Eigen::MatrixXd& a);
/// The w of a x = w b x with b positive definite, smallest first (GeneralizedSelfAdjointEigenSolver).
Eigen::VectorXd self_adjoint_eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace rubsweep::numerics::dense
