#pragma once

#include <Eigen/Core>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"

namespace rubsweep::numerics::spectral {

/// Decompositions of complex matrices and of pairs of symmetric ones, whose size is known at run time.
/// Eigen's templates are compiled here once, and not at all for programs that do not use them.

/// The same as dense::self_adjoint_modes for a Hermitian matrix.
dense::SelfAdjointModes<Eigen::MatrixXcd> hermitian_modes(const Eigen::MatrixXcd& a);

/// Eigenvalues w of a x = w b x with b positive definite, in ascending order
/// (GeneralizedSelfAdjointEigenSolver); all NaN where the iteration does not converge.
Eigen::VectorXd generalized_eigenvalues(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The same as dense::orthonormal_columns for a complex matrix.
Eigen::MatrixXcd unitary_columns(const Eigen::MatrixXcd& a, Eigen::Index count);

/// Singular value decomposition a = u diag(values) v^T (JacobiSVD), largest value first; u and v have as many
/// columns as there are values. Compiled here once.
struct SingularValues {
  Eigen::MatrixXd u, v;
  Eigen::VectorXd values;
};
SingularValues singular_values(const Eigen::MatrixXd& a);

}  // namespace rubsweep::numerics::spectral
