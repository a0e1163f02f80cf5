#include "rubsweep/core/numerics/pair_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace rubsweep::numerics {
namespace {

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

TEST(PairFlow, IsTheMatrixExponentialOfEveryKindOfPair) {
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

TEST(PairFlow, DoesNotOverflowWhereDampingIsHuge) {
  const Pair flow = pair_flow({0, 1, -1, -1e4}, 1.0);
  EXPECT_NEAR(flow.uu, std::exp(-1e-4), 1e-7);
  EXPECT_TRUE(std::isfinite(flow.vv));
}

}  // namespace
}  // namespace rubsweep::numerics
