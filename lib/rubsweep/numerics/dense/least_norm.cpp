#include "rubsweep/numerics/dense/least_norm.hpp"

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

}  // namespace rubsweep::numerics::dense
