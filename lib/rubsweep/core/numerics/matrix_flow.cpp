#include "rubsweep/core/numerics/matrix_flow.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "rubsweep/core/numerics/long_matrix.hpp"
#include "rubsweep/core/numerics/step_table.hpp"

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

/// e^|A t| for a short time, entry by entry a bound of e^{A s} for |s| <= t. Where a unit of time is long or
/// short beside the motion, the exponential is taken in another one: its squarings would lose the small
/// entries beside the large ones. By powers of two, which cost no rounding.
MatrixXd bound_between(const MatrixXd& generator, double duration_s) {
  constexpr int far_from_the_unit = 20;  // binary orders: rounding still leaves three digits of each entry
  const Eigen::Index n = generator.rows() / 2, m = generator.rows() - n;
  const double largest = generator.bottomLeftCorner(m, n).cwiseAbs().maxCoeff();
  const int order = largest > 0 ? std::ilogb(std::sqrt(largest)) : 0;
  const double unit = std::abs(order) > far_from_the_unit ? std::ldexp(1.0, order) : 1;
  MatrixXd exponent = generator.cwiseAbs() * duration_s;
  exponent.topRightCorner(n, m) *= unit;
  exponent.bottomLeftCorner(m, n) /= unit;
  MatrixXd bound = exponent.exp();
  bound.topRightCorner(n, m) /= unit;
  bound.bottomLeftCorner(m, n) *= unit;
  return bound;
}

}  // namespace

MatrixXd matrix_flow(const MatrixXd& generator, double duration_s) {
  return long_flow(generator, duration_s).cast<double>();
}

void make_matrix_flows(const MatrixXd& generator, double longest_s, int k,
                       const std::function<void(int, const MatrixXd&)>& put) {
  constexpr int squarings = 6;  // rounding grows at most 2^6 times, which long double has to spare
  const int shortest = exact_step_count - 2 + k % 2;
  const int level = (shortest - k) / 2;  // from the shortest step up; a group begins with its shortest
  int i = shortest - 2 * (level - level % (squarings + 1));
  LongMatrix flow = long_flow(generator, longest_s * exact_step_size(i));
  put(i, flow.cast<double>());
  for (int n = 0; n < squarings && i >= 2; ++n) {
    i -= 2;
    flow = LongMatrix(flow * flow);
    put(i, flow.cast<double>());
  }
}

FlowBound::FlowBound(const MatrixXd& generator, double horizon_s, double fastest_rad_per_s)
    : points_(static_cast<int>(std::ceil(16 * horizon_s * fastest_rad_per_s)) + 1),
      step_(matrix_flow(generator, horizon_s / points_)),
      between_(bound_between(generator, horizon_s / points_)) {}

RowVectorXd FlowBound::of(const RowVectorXd& row) const {
  RowVectorXd now = row, largest = RowVectorXd::Zero(row.size());
  for (int i = 0; i <= points_; ++i) {
    largest = largest.cwiseMax(now.cwiseAbs());
    now = now * step_;
  }
  return largest * between_;
}

}  // namespace rubsweep::numerics
