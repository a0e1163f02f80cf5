#include "rubsweep/core/numerics/matrix_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <set>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

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

/// A slow and a fast oscillator with one-way coupling, as by friction: u1 drives u2.
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

/// Compares the bound with a grid a hundred times finer than the one it is computed from.
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

Eigen::Matrix2d exponential(const Pair& g, double duration) {
  Eigen::Matrix<long double, 2, 2> a;
  a << g.uu, g.uv, g.vu, g.vv;
  return (a * static_cast<long double>(duration)).exp().cast<double>();
}

void expect_flow(const Pair& g, double duration) {
  const Pair flow = pair_flow(g, duration);
  const Eigen::Matrix2d expected = exponential(g, duration);
  const double size = std::max(1.0, expected.cwiseAbs().maxCoeff());
  EXPECT_NEAR(flow.uu, expected(0, 0), 2e-14 * size);
  EXPECT_NEAR(flow.uv, expected(0, 1), 2e-14 * size);
  EXPECT_NEAR(flow.vu, expected(1, 0), 2e-14 * size);
  EXPECT_NEAR(flow.vv, expected(1, 1), 2e-14 * size);
}

TEST(MatrixFlowPairFlow, IsTheMatrixExponentialOfEveryKindOfPair) {
  for (const double duration : {0.0, 1e-9, 0.3, 2.0, -0.7}) {
    SCOPED_TRACE(duration);
    for (const double damping : {0.0, 0.1, 1.9, 2.0, 2.0 + 1e-9, 2.1, 5.0}) {
      SCOPED_TRACE(damping);
      expect_flow({0, 1, -1, -damping}, duration);
    }
    expect_flow({-0.2, 3, -3, -0.2}, duration);
    expect_flow({-0.2, 0, 0, -4}, duration);
    expect_flow({0, 1, 0, 0}, duration);
  }
}

TEST(MatrixFlowPairFlow, DoesNotOverflowWhereDampingIsHuge) {
  const Pair flow = pair_flow({0, 1, -1, -1e4}, 1.0);
  EXPECT_NEAR(flow.uu, std::exp(-1e-4), 1e-7);
  EXPECT_TRUE(std::isfinite(flow.vv));
}

/// Pairs of undamped, lightly, critically and strongly damped oscillators, a spiral, and two real
/// eigenvalues.
const std::vector<Pair> every_kind{{0, 5, -5, 0},   {0, 5, -5, -1},  {0, 5, -5, -10},
                                   {0, 1, -25, -2}, {-1, 4, -4, -1}, {-1, 0, 0, -5}};

TEST(MatrixFlowPairSeries, SumsToTheFlow) {
  constexpr double fastest = 10;
  const PairSeries series = pair_series(every_kind, fastest);
  for (std::size_t j = 0; j < every_kind.size(); ++j) {
    for (const double x : {-1.0, 0.03, 0.5, 1.0}) {
      double unit = 0, generator = 0;
      for (Eigen::Index k = most_series_terms; k-- > 0;) {
        unit = unit * x + series.unit(static_cast<Eigen::Index>(j), k);
        generator = generator * x + series.generator(static_cast<Eigen::Index>(j), k);
      }
      const Pair& g = every_kind[j];
      const Pair flow = pair_flow(g, x / fastest);
      EXPECT_NEAR(unit + generator * g.uu, flow.uu, 1e-14) << j << ' ' << x;
      EXPECT_NEAR(generator * g.uv, flow.uv, 1e-14) << j << ' ' << x;
      EXPECT_NEAR(generator * g.vu, flow.vu, 1e-14) << j << ' ' << x;
      EXPECT_NEAR(unit + generator * g.vv, flow.vv, 1e-14) << j << ' ' << x;
    }
  }
}

TEST(MatrixFlowPairSeries, StartsAtTheUnitMatrix) {
  const PairSeries series = pair_series(every_kind, 10);
  EXPECT_TRUE((series.unit.col(0) == 1).all());
  EXPECT_TRUE((series.generator.col(0) == 0).all());
  EXPECT_TRUE((series.generator.col(1) == 0.1).all());
}

}  // namespace

}  // namespace rubsweep::numerics
