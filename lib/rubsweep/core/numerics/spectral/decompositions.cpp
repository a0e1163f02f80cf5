#include "rubsweep/core/numerics/spectral/decompositions.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <limits>

namespace rubsweep::numerics::spectral {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

dense::SelfAdjointModes<MatrixXcd> hermitian_modes(const MatrixXcd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXcd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors(), solver.info() == Eigen::Success};
}

VectorXd generalized_eigenvalues(const MatrixXd& a, const MatrixXd& b) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(a, b, Eigen::EigenvaluesOnly);
  if (solver.info() == Eigen::Success) return solver.eigenvalues();
  return VectorXd::Constant(a.rows(), std::numeric_limits<double>::quiet_NaN());
}

MatrixXcd unitary_columns(const MatrixXcd& a, Eigen::Index count) {
  return a.householderQr().householderQ() * MatrixXcd::Identity(a.rows(), count);
}

SingularValues singular_values(const Eigen::MatrixXd& a) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return {svd.matrixU(), svd.matrixV(), svd.singularValues()};
}

}  // namespace rubsweep::numerics::spectral
