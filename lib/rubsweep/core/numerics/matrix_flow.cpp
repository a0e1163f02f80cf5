#include "rubsweep/core/numerics/matrix_flow.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace rubsweep::numerics {
namespace {

/// cos(sqrt(x)) and sin(sqrt(x)) / sqrt(x); for x <= 0 continued by the hyperbolic functions.
struct CosineAndSinc {
  double c, s;
};

CosineAndSinc cosine_and_sinc(double x) {
  // The series here is exact to rounding on both sides of zero.
  if (std::abs(x) < 1e-2) {
    return {1 - x / 2 * (1 - x / 12 * (1 - x / 30 * (1 - x / 56 * (1 - x / 90)))),
            1 - x / 6 * (1 - x / 20 * (1 - x / 42 * (1 - x / 72 * (1 - x / 110))))};
  }
  const double root = std::sqrt(std::abs(x));
  if (x > 0) return {std::cos(root), std::sin(root) / root};
  return {std::cosh(root), std::sinh(root) / root};
}

}  // namespace

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

/// Scales time so that displacements and velocities are of equal size: the exponent then has about the norm
/// of its eigenvalues and needs fewer squarings.
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

/// Entries of e^|A t| for a short time t, which bound those of e^{A s} for |s| <= t. Where the motion is much
/// faster or slower than the unit of time, time is rescaled, because squaring would lose entries that are
/// small compared with others. Scaling by powers of two adds no rounding.
MatrixXd bound_between(const MatrixXd& generator, double duration_s) {
  constexpr int far_from_the_unit = 20;  // binary orders; with less than this, each entry keeps three digits
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
  constexpr int squarings = 6;  // rounding grows at most by 2^6, which the extra digits of long double cover
  const int shortest = exact_step_count - 2 + k % 2;
  const int level = (shortest - k) / 2;  // level above the shortest step; a group starts at its shortest
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

Pair pair_flow(const Pair& g, double duration) {
  const double mean = (g.uu + g.vv) / 2, half = (g.uu - g.vv) / 2;
  // det - mean^2, without the cancellation in the product of the diagonal.
  const double q = -g.uv * g.vu - half * half;
  const double square = q * duration * duration;
  double c = 0, s = 0;
  if (square < -100) {
    // cosh alone would overflow, although its product with the decay is small.
    const double root = std::sqrt(-q);
    const double slow = std::exp((mean + root) * duration), fast = std::exp((mean - root) * duration);
    c = (slow + fast) / 2;
    s = (slow - fast) / (2 * root);
  } else {
    const auto pair = cosine_and_sinc(square);
    const double decay = std::exp(mean * duration);
    c = decay * pair.c;
    s = decay * pair.s * duration;
  }
  return {c + s * half, s * g.uv, s * g.vu, c - s * half};
}

/// By Cayley and Hamilton, G^2 = trace G - determinant: every power of G is a combination of 1 and G.
PairSeries pair_series(const std::vector<Pair>& generators, double fastest_rad_per_s) {
  const auto count = static_cast<Eigen::Index>(generators.size());
  PairSeries series;
  series.unit.setZero(count, most_series_terms);
  series.generator.setZero(count, most_series_terms);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Pair& g = generators[static_cast<std::size_t>(j)];
    const double trace = (g.uu + g.vv) / fastest_rad_per_s;
    const double determinant = (g.uu * g.vv - g.uv * g.vu) / (fastest_rad_per_s * fastest_rad_per_s);
    double unit = 1, generator = 0;  // coefficients of G^k / k!, time in units of 1 / fastest
    for (std::size_t k = 0; k < most_series_terms; ++k) {
      series.unit(j, static_cast<Eigen::Index>(k)) = unit;
      series.generator(j, static_cast<Eigen::Index>(k)) = generator / fastest_rad_per_s;
      const double last = generator;
      generator = reciprocals[k + 1] * (unit + trace * last);
      unit = -reciprocals[k + 1] * determinant * last;
    }
  }
  return series;
}

}  // namespace rubsweep::numerics
