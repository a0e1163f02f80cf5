#include "rubsweep/analysis/branch/curves/conditions.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"

namespace rubsweep::branch::curves {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Solution of the nearly singular system without the contribution of the smallest singular value.
VectorXd solve_but_last(const numerics::spectral::SingularValues& svd, const VectorXd& right) {
  const Eigen::Index rank = right.size() - 1;
  return svd.v.leftCols(rank) *
         (svd.u.leftCols(rank).transpose() * right).cwiseQuotient(svd.values.head(rank));
}

struct SumAndProduct {
  double sum = 0, product = 0;
};

SumAndProduct nearest_pair(const MatrixXd& monodromy) {
  const Eigen::VectorXcd multipliers = numerics::dense::eigenvalues(monodromy);
  SumAndProduct nearest;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < multipliers.size(); ++i) {
    for (Eigen::Index j = i + 1; j < multipliers.size(); ++j) {
      const std::complex<double> a = multipliers(i), b = multipliers(j);
      const bool real_pair = (a.imag() == 0 && b.imag() == 0) || b == std::conj(a);
      if (!real_pair || std::abs(a * b - 1.0) >= least) continue;
      least = std::abs(a * b - 1.0);
      nearest = {(a + b).real(), (a * b).real()};
    }
  }
  return nearest;
}

}  // namespace

std::optional<Condition> singular_condition(const MonodromyJet& jet, double sign) {
  const Eigen::Index n = jet.here.rows(), last = n - 1;
  const MatrixXd one = MatrixXd::Identity(n, n);
  const numerics::spectral::SingularValues svd = numerics::spectral::singular_values(jet.here - sign * one);
  const VectorXd left = svd.u.col(last), right = svd.v.col(last);
  const auto beside = jet.along(right);
  if (!beside) return std::nullopt;
  const MatrixXd slope = beside->slope();
  Condition condition;
  condition.value = svd.values(last);
  condition.by_state = left.transpose() * slope;
  condition.by_parameter.resize(static_cast<Eigen::Index>(jet.by_parameter.size()));
  for (Eigen::Index i = 0; i < condition.by_parameter.size(); ++i)
    condition.by_parameter(i) = left.dot(jet.by_parameter[static_cast<std::size_t>(i)] * right);
  Critical& critical = condition.critical;
  critical.left = left;
  critical.right = right;
  critical.quadratic = condition.by_state.dot(right);
  // Coefficients of Kuznetsov, Elements of Applied Bifurcation Theory, (5.50) and (5.53), times six.
  const VectorXd squared = slope * right;
  const VectorXd answer =
      sign > 0 ? solve_but_last(svd, squared) : numerics::dense::solve(jet.here - one, squared);
  const MatrixXd bend = (beside->ahead - 2 * jet.here + beside->behind) / (beside->step * beside->step);
  critical.cubic = left.dot(bend * right) - 3 * condition.by_state.dot(answer);
  return condition;
}

std::optional<Condition> pair_condition(const MonodromyJet& jet) {
  const MatrixXd& m = jet.here;
  const Eigen::Index n = m.rows();
  if (n < 2) return std::nullopt;
  const auto [sum, product] = nearest_pair(m);
  const numerics::spectral::SingularValues svd =
      numerics::spectral::singular_values(m * m - sum * m + product * MatrixXd::Identity(n, n));
  const MatrixXd left = svd.u.rightCols(2), right = svd.v.rightCols(2);
  const Eigen::Matrix2d overlap = left.transpose() * right;
  const Eigen::MatrixXd weighed = overlap.inverse() * left.transpose();  // 2 x n
  const Eigen::Matrix2d block = weighed * m * right;
  Eigen::Matrix2d adjugate;
  adjugate << block(1, 1), -block(0, 1), -block(1, 0), block(0, 0);
  const MatrixXd rows = adjugate * weighed;
  Condition condition;
  condition.value = block.determinant() - 1;
  condition.critical.pair_sum = block.trace();
  condition.by_state = Eigen::RowVectorXd::Zero(n);
  for (Eigen::Index k = 0; k < 2; ++k) {
    const auto beside = jet.along(right.col(k));
    if (!beside) return std::nullopt;
    condition.by_state += rows.row(k) * beside->slope();
  }
  condition.by_parameter.resize(static_cast<Eigen::Index>(jet.by_parameter.size()));
  for (Eigen::Index i = 0; i < condition.by_parameter.size(); ++i)
    condition.by_parameter(i) = (rows * jet.by_parameter[static_cast<std::size_t>(i)] * right).trace();
  return condition;
}

}  // namespace rubsweep::branch::curves
