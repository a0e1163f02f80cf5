#include "rubsweep/numerics/dense/orthogonal.hpp"

#include <Eigen/QR>

namespace rubsweep::numerics::dense {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}
MatrixXd least_norm_solution(const MatrixXd& a, const MatrixXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}
VectorXcd least_norm_solution(const MatrixXcd& a, const VectorXcd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}

MatrixXd orthonormal_columns(const MatrixXd& a, Eigen::Index count) {
  return a.householderQr().householderQ() * MatrixXd::Identity(a.rows(), count);
}
MatrixXcd orthonormal_columns(const MatrixXcd& a, Eigen::Index count) {
  return a.householderQr().householderQ() * MatrixXcd::Identity(a.rows(), count);
}

}  // namespace rubsweep::numerics::dense
