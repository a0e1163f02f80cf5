#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::dense {

/// Eigenvalues of a real square matrix, in the order of Eigen's EigenSolver. All are NaN where its iteration
/// does not converge or the matrix is not finite. Defined here so that its templates are compiled once.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// Eigenvalues and eigenvectors, one per column. Vectors of a pair of complex eigenvalues are conjugate.
struct Eigenvectors {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
Eigenvectors eigenvectors(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a real square matrix and, on request, eigenvectors of unit length as columns.
/// `iterations_per_row`: largest number of QR steps per row; Eigen's own limit is 40.
struct GeneralModes {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
  bool converged = false;  ///< false: there are no values
};
GeneralModes general_modes(const Eigen::MatrixXd& matrix, bool with_vectors,
                           Eigen::Index iterations_per_row = 40);

/// Spectral radius, the largest |eigenvalue|. For a monodromy matrix it is the modulus of the largest
/// multiplier, for a generator its fastest rate. NaN where the eigenvalues are NaN.
double spectral_radius(const Eigen::MatrixXd& matrix);

/// Eigenvalues in ascending order and orthonormal eigenvectors of a self-adjoint matrix
/// (SelfAdjointEigenSolver). Defined here so that Eigen's templates are compiled once.
template <class Matrix>
struct SelfAdjointModes {
  Eigen::VectorXd values;
  Matrix vectors;
  bool converged = false;
};
SelfAdjointModes<Eigen::MatrixXd> self_adjoint_modes(const Eigen::MatrixXd& a);

/// Eigenvalues of a symmetric matrix in ascending order; all NaN where the iteration does not converge.
Eigen::VectorXd self_adjoint_eigenvalues(const Eigen::MatrixXd& a);

}  // namespace rubsweep::numerics::dense
