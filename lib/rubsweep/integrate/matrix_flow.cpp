#include "rubsweep/integrate/matrix_flow.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace rubsweep::integrate {

using Eigen::MatrixXd;
using Eigen::RowVectorXd;

MatrixXd generator_of(const MatrixXd& stiffness, const MatrixXd& damping) {
  const Eigen::Index n = stiffness.rows();
  MatrixXd a = MatrixXd::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -stiffness;
  a.bottomRightCorner(n, n) = -damping;
  return a;
}

MatrixXd matrix_flow(const MatrixXd& generator, double duration_s) {
  using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  const LongMatrix exponent = generator.cast<long double>() * static_cast<long double>(duration_s);
  return LongMatrix(exponent.exp()).cast<double>();
}

RowVectorXd bound_of_flow(const MatrixXd& generator, const RowVectorXd& row, double horizon_s,
                          double fastest_rad_per_s) {
  const int points = static_cast<int>(std::ceil(16 * horizon_s * fastest_rad_per_s)) + 1;
  const double spacing = horizon_s / points;
  const MatrixXd step = matrix_flow(generator, spacing);
  const MatrixXd between = (generator.cwiseAbs() * spacing).exp();
  RowVectorXd now = row, largest = RowVectorXd::Zero(row.size());
  for (int i = 0; i <= points; ++i) {
    largest = largest.cwiseMax(now.cwiseAbs());
    now = now * step;
  }
  return largest * between;
}

}  // namespace rubsweep::integrate
