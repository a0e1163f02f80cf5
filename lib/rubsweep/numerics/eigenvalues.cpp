#include "rubsweep/numerics/eigenvalues.hpp"

#include <Eigen/Eigenvalues>

namespace rubsweep::numerics {

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& matrix) { return matrix.eigenvalues(); }

Eigenvectors eigenvectors(const Eigen::MatrixXd& matrix) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

double spectral_radius(const Eigen::MatrixXd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

}  // namespace rubsweep::numerics
