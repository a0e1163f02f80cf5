#pragma once

#include <Eigen/Core>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"

namespace rubsweep::numerics::spectral {

/// Decompositions of complex matrices, and of pairs of symmetric ones, whose size is known at run time. Here
/// so that Eigen's templates are compiled once, and not at all for programs that do without.

/// As dense::self_adjoint_modes, of a Hermitian matrix.
dense::SelfAdjointModes<Eigen::MatrixXcd> hermitian_modes(const Eigen::MatrixXcd& a);

/// The w of a x = w b x with b positive definite, smallest first (GeneralizedSelfAdjointEigenSolver); all NaN
/// where the iteration does not converge.
Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// As dense::orthonormal_columns, of a complex matrix.
Eigen::MatrixXcd unitary_columns(const Eigen::MatrixXcd& a, Eigen::Index count);

/// Singular value decomposition a = u diag(values) v^T (JacobiSVD), largest value first, with as many columns
/// of u and v as there are values. Here so that Eigen's templates are compiled once.
struct SingularValues {
  Eigen::MatrixXd u, v;
  Eigen::VectorXd values;
};
SingularValues singular_values(const Eigen::MatrixXd& a);

}  // namespace rubsweep::numerics::spectral
