#include "rubsweep/numerics/dense/self_adjoint.hpp"

#include <Eigen/Eigenvalues>

namespace rubsweep::numerics::dense {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

template <class Matrix>
SelfAdjointModes<Matrix> modes_of(const Matrix& a) {
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors(), solver.info() == Eigen::Success};
}

}  // namespace

SelfAdjointModes<MatrixXd> self_adjoint_modes(const MatrixXd& a) { return modes_of(a); }
SelfAdjointModes<MatrixXcd> self_adjoint_modes(const MatrixXcd& a) { return modes_of(a); }

VectorXd self_adjoint_eigenvalues(const MatrixXd& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}
VectorXd self_adjoint_eigenvalues(const MatrixXd& a, const MatrixXd& b) {
  return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(a, b, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace rubsweep::numerics::dense
