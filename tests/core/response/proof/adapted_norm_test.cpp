#include "rubsweep/core/response/proof/adapted_norm.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/spectral/singular_values.hpp"

namespace rubsweep::response::proof {
namespace {

using Eigen::Matrix2d;
using Eigen::MatrixXd;

double size_in(const MatrixXd& from, const MatrixXd& turn, const MatrixXd& to) {
  const MatrixXd map = to * turn * from.inverse();
  return numerics::spectral::singular_values(map).values(0);
}

/// A focus that decays slowly: the maximum norm of a disturbance halves by turning alone.
TEST(AdaptedNorms, ContractWhereTheMaximumNormOnlyTurns) {
  const double shrink = 0.999, angle = 0.7, stretch = 20;
  Matrix2d turn;
  turn << std::cos(angle), -stretch * std::sin(angle), std::sin(angle) / stretch, std::cos(angle);
  turn *= shrink;
  EXPECT_GT(turn.cwiseAbs().rowwise().sum().maxCoeff(), 1);
  const auto norms = adapted_norms({turn});
  ASSERT_TRUE(norms);
  EXPECT_NEAR(norms->contraction, (1 + shrink) / 2, 1e-12);
  EXPECT_LE(size_in(norms->norm[0], turn, norms->norm[0]), norms->contraction * (1 + 1e-9));
}

TEST(AdaptedNorms, EveryTurnOfAPeriodContracts) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<MatrixXd> turns(3, MatrixXd(6, 6));
    MatrixXd monodromy = MatrixXd::Identity(6, 6);
    for (MatrixXd& turn : turns) {
      for (double& x : turn.reshaped()) x = normal(random);
      monodromy = turn * monodromy;
    }
    const double wanted = std::uniform_real_distribution(0.1, 0.9999)(random);
    const double factor = std::cbrt(wanted / numerics::dense::spectral_radius(monodromy));
    for (MatrixXd& turn : turns) turn *= factor;
    const auto norms = adapted_norms(turns);
    ASSERT_TRUE(norms);
    EXPECT_LT(norms->contraction, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      const MatrixXd& here = norms->norm[k];
      EXPECT_LE(size_in(here, turns[k], norms->norm[(k + 1) % 3]), norms->contraction * (1 + 1e-7));
      EXPECT_GE(numerics::spectral::singular_values(here).values.minCoeff(), 1 - 1e-9);
    }
  }
}

TEST(AdaptedNorms, NoneOnTheUnitCircleOrOutside) {
  EXPECT_FALSE(adapted_norms({MatrixXd::Identity(2, 2)}));
  EXPECT_FALSE(adapted_norms({2 * MatrixXd::Identity(2, 2), MatrixXd::Identity(2, 2)}));
  EXPECT_TRUE(adapted_norms({2 * MatrixXd::Identity(2, 2), 0.4 * MatrixXd::Identity(2, 2)}));
}

}  // namespace
}  // namespace rubsweep::response::proof
