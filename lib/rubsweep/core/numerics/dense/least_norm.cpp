#include "rubsweep/core/numerics/dense/least_norm.hpp"

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
  const Eigen::Index rows = a.rows(), columns = a.cols();
  MatrixXd parts(2 * rows, 2 * columns);
  parts << a.real(), -a.imag(), a.imag(), a.real();
  VectorXd sides(2 * rows);
  sides << b.real(), b.imag();
  const VectorXd x = least_norm_solution(parts, sides);
  VectorXcd joined(columns);
  joined.real() = x.head(columns);
  joined.imag() = x.tail(columns);
  return joined;
}

MatrixXd orthonormal_columns(const MatrixXd& a, Eigen::Index count) {
  return a.householderQr().householderQ() * MatrixXd::Identity(a.rows(), count);
}

}  // namespace rubsweep::numerics::dense
