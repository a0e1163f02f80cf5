#include "rubsweep/core/numerics/matrix_flow.hpp"

#include <gtest/gtest.h>

#include <set>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/pair_flow.hpp"
#include "rubsweep/core/numerics/step_table.hpp"

namespace rubsweep::numerics {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

TEST(MatrixFlowGeneratorOf, HoldsTheEquationOfMotion) {
  Matrix2d k, c;
  k << 4, -1, -2, 5;
  c << 0.3, 0, 0.1, 0.2;
  const MatrixXd a = generator_of(k, c);
  const Eigen::Vector4d state(1, 2, 3, 4);
  Eigen::Vector4d rate;
  rate << state.tail<2>(), -k * state.head<2>() - c * state.tail<2>();
  EXPECT_LT((a * state - rate).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(MatrixFlow, OfOneOscillatorIsItsPairFlow) {
  for (const double damping : {0.0, 0.5, 6.0, 40.0}) {  // 6: critical
    const MatrixXd a = generator_of(MatrixXd::Constant(1, 1, 9), MatrixXd::Constant(1, 1, damping));
    const Pair flow = pair_flow({a(0, 0), a(0, 1), a(1, 0), a(1, 1)}, 0.7);
    Matrix2d expected;
    expected << flow.uu, flow.uv, flow.vu, flow.vv;
    EXPECT_LT((matrix_flow(a, 0.7) - expected).cwiseAbs().maxCoeff(), 1e-15) << damping;
  }
}

TEST(MatrixFlow, OfTwoStretchesIsTheirProduct) {
  Matrix2d k, c;
  k << 400, -100, -200, 5e4;
  c << 3, 0, 1, 20;
  const MatrixXd a = generator_of(k, c);
  const MatrixXd apart = matrix_flow(a, 0.02) * matrix_flow(a, 0.03) - matrix_flow(a, 0.05);
  EXPECT_LT(apart.cwiseAbs().maxCoeff(), 1e-12);
}

/// Slow and fast, and friction-like one-way coupling: u2 is driven by u1.
TEST(MatrixFlow, TheTableHoldsTheFlowOfEveryStep) {
  Matrix2d k, c;
  k << 4e8, 0, 3e7, 900;
  c << 50, 0, 0, 2;
  const MatrixXd generator = generator_of(k, c);
  const double longest_s = 16 / 2e4;
  for (int step = 0; step < exact_step_count; ++step) {
    std::set<int> made;
    make_matrix_flows(generator, longest_s, step, [&](int i, const MatrixXd& found) {
      const MatrixXd flow = matrix_flow(generator, longest_s * exact_step_size(i));
      EXPECT_LT(((found - flow).array() / (flow.array().abs() + 1e-9)).abs().maxCoeff(), 1e-13) << i;
      EXPECT_TRUE(made.insert(i).second) << i;
    });
    EXPECT_TRUE(made.contains(step)) << step;
    EXPECT_LE(made.size(), 7) << step;
  }
}

/// Against a grid a hundred times finer than the one the bound is made from.
TEST(MatrixFlowBound, IsNeverExceededAndNotFarAbove) {
  Matrix2d k, c;
  k << 4, -1, 30, 50;
  c << 0.1, 0, -2, 0.2;
  const MatrixXd a = generator_of(k, c);
  RowVectorXd row(4);
  row << 1, -2, 0.5, 0.1;
  const double fastest = dense::spectral_radius(a), horizon = 2;
  const RowVectorXd bound = FlowBound(a, horizon, fastest).of(row);
  RowVectorXd largest = RowVectorXd::Zero(4);
  for (int i = 0; i <= 3000; ++i)
    largest = largest.cwiseMax((row * matrix_flow(a, horizon * i / 3000)).cwiseAbs());
  for (Eigen::Index j = 0; j < 4; ++j) {
    EXPECT_GE(bound(j), largest(j)) << j;
    EXPECT_LE(bound(j), 30 * largest.maxCoeff()) << j;
  }
}

TEST(MatrixFlowBound, DoesNotDependOnTheUnitOfTime) {
  const Matrix2d k{{4e8, -1e8}, {3e9, 5e9}}, c{{1e3, 0}, {-2e3, 2e3}};
  const auto in_unit = [&](int order) {
    const double faster = std::ldexp(1.0, order);
    const MatrixXd a = generator_of(faster * faster * k, faster * c);
    RowVectorXd row(4);
    row << 1, -2, 5e-6 / faster, 1e-6 / faster;
    RowVectorXd bound = FlowBound(a, 3e-5 / faster, 7e4 * faster).of(row);
    bound.tail(2) *= faster;
    return bound;
  };
  const RowVectorXd usual = in_unit(0);
  for (const int order : {8, 20, 40, -20})
    EXPECT_LT((in_unit(order) - usual).cwiseQuotient(usual).cwiseAbs().maxCoeff(), 1e-6) << order;
}

}  // namespace
}  // namespace rubsweep::numerics
