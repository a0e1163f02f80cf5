#pragma once

#include <Eigen/Core>

namespace rubsweep::numerics::dense {

/// Eigenvalues of a real square matrix, in the order that Eigen's EigenSolver finds them; all NaN where its
/// iteration does not converge or the matrix is not finite. Here so that its templates are compiled once.
Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix);

/// The same with their eigenvectors, one per column. Those of a pair of complex eigenvalues are conjugate.
struct Eigenvectors {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};
Eigenvectors eigenvectors(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a real square matrix and, where asked for, eigenvectors of unit length, one a column.
/// `iterations_per_row`: after so many QR steps a row it gives up; Eigen's own limit is 40.
struct GeneralModes {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
  bool converged = false;  ///< else there are no values
};
GeneralModes general_modes(const Eigen::MatrixXd& matrix, bool with_vectors,
                           Eigen::Index iterations_per_row = 40);

/// Spectral radius, the largest |eigenvalue|: of a monodromy matrix the modulus of the largest multiplier, of
/// a generator its fastest rate. NaN where the eigenvalues are.
double spectral_radius(const Eigen::MatrixXd& matrix);

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
