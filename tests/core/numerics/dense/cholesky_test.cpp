#include "rubsweep/core/numerics/dense/cholesky.hpp"

#include <gtest/gtest.h>

namespace rubsweep::numerics::dense {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(Cholesky, FactorsMultiplyToTheMatrixAndSolveIt) {
  const MatrixXd a{{4, 2, 0}, {2, 5, 1}, {0, 1, 3}};
  const CholeskyFactors factors(a);
  ASSERT_TRUE(factors.positive_definite());
  const MatrixXd upper = factors.upper(), one = MatrixXd::Identity(3, 3);
  EXPECT_LE((upper.transpose() * upper - a).norm(), 1e-15 * a.norm());
  EXPECT_LE((upper * factors.solve_upper(one) - one).norm(), 1e-15);
  EXPECT_LE((upper.transpose() * factors.solve_lower(one) - one).norm(), 1e-15);
  EXPECT_LE((a * factors.solve(one) - one).norm(), 1e-14);
  const VectorXd b{{1, 2, 3}};
  EXPECT_LE((a * factors.solve(b) - b).norm(), 1e-14);
}

TEST(Cholesky, SaysWhereAMatrixIsNotPositiveDefinite) {
  EXPECT_FALSE(CholeskyFactors(MatrixXd{{1, 2}, {2, 1}}).positive_definite());
}

TEST(CholeskySymmetricFactors, SolveIndefiniteMatricesToo) {
  const MatrixXd a{{1, 2, 0}, {2, 1, -3}, {0, -3, 4}}, one = MatrixXd::Identity(3, 3);
  const SymmetricFactors factors(a);
  EXPECT_LE((a * factors.solve(one) - one).norm(), 1e-14);
  const VectorXd b{{1, 2, 3}};
  EXPECT_LE((a * factors.solve(b) - b).norm(), 1e-14);
}

}  // namespace
}  // namespace rubsweep::numerics::dense
