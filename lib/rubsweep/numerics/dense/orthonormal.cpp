#include "rubsweep/numerics/dense/orthonormal.hpp"

#include <Eigen/QR>

namespace rubsweep::numerics::dense {

using Eigen::MatrixXd;

MatrixXd orthonormal_columns(const MatrixXd& a, Eigen::Index count) {
  return a.householderQr().householderQ() * MatrixXd::Identity(a.rows(), count);
}

}  // namespace rubsweep::numerics::dense
