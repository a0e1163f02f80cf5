#include "rubsweep/numerics/matrix_flow.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "rubsweep/numerics/step_table.hpp"

namespace rubsweep::numerics {

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

namespace {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// In units of time that make displacements and velocities alike: of the same norm as the eigenvalues, the
/// exponent takes fewer squarings.
LongMatrix long_flow(const MatrixXd& generator, double duration_s) {
  const Eigen::Index n = generator.rows() / 2, m = generator.rows() - n;
  const double largest = generator.bottomLeftCorner(m, n).cwiseAbs().maxCoeff();
  const long double unit = largest > 0 ? std::sqrt(largest) : 1;
  LongMatrix exponent = generator.cast<long double>() * static_cast<long double>(duration_s);
  exponent.topRightCorner(n, m) *= unit;
  exponent.bottomLeftCorner(m, n) /= unit;
  LongMatrix flow = exponent.exp();
  flow.topRightCorner(n, m) /= unit;
  flow.bottomLeftCorner(m, n) *= unit;
  return flow;
}

}  // namespace

MatrixXd matrix_flow(const MatrixXd& generator, double duration_s) {
  return long_flow(generator, duration_s).cast<double>();
}

std::vector<MatrixXd> matrix_flows(const MatrixXd& generator, double longest_s) {
  constexpr int squarings = 6;  // rounding grows at most 2^6 times, which long double has to spare
  std::vector<MatrixXd> flows(exact_step_count);
  for (const int odd : {0, 1}) {
    LongMatrix flow;
    int level = 0;  // from the shortest step up
    for (int k = exact_step_count - 2 + odd; k >= 0; k -= 2, ++level) {
      flow = level % (squarings + 1) == 0 ? long_flow(generator, longest_s * exact_step_size(k))
                                          : LongMatrix(flow * flow);
      flows[static_cast<std::size_t>(k)] = flow.cast<double>();
    }
  }
  return flows;
}

FlowBound::FlowBound(const MatrixXd& generator, double horizon_s, double fastest_rad_per_s)
    : points_(static_cast<int>(std::ceil(16 * horizon_s * fastest_rad_per_s)) + 1),
      step_(matrix_flow(generator, horizon_s / points_)),
      between_((generator.cwiseAbs() * (horizon_s / points_)).exp()) {}

RowVectorXd FlowBound::of(const RowVectorXd& row) const {
  RowVectorXd now = row, largest = RowVectorXd::Zero(row.size());
  for (int i = 0; i <= points_; ++i) {
    largest = largest.cwiseMax(now.cwiseAbs());
    now = now * step_;
  }
  return largest * between_;
}

}  // namespace rubsweep::numerics
