#include "rubsweep/core/numerics/dense/self_adjoint.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace rubsweep::numerics::dense {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SelfAdjointModes<MatrixXd> self_adjoint_modes(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors(), solver.info() == Eigen::Success};
}

VectorXd self_adjoint_eigenvalues(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a, Eigen::EigenvaluesOnly);
  if (solver.info() == Eigen::Success) return solver.eigenvalues();
  return VectorXd::Constant(a.rows(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace rubsweep::numerics::dense
