#include "rubsweep/core/numerics/dense/factors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace rubsweep::numerics::dense {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr std::complex<double> i{0, 1};

TEST(FactorsLu, SolvesRealAndComplexSystems) {
  const MatrixXd a{{2, 1, 0}, {-1, 3, 4}, {0, 0.5, -1}};
  const VectorXd b{{1, -2, 3}};
  EXPECT_LE((a * solve(a, b) - b).norm(), 1e-14);
  const MatrixXcd c = a + i * MatrixXd{{0, 1, 2}, {3, 0, 1}, {1, 1, 0}};
  const MatrixXcd right = MatrixXcd::Identity(3, 3) * (2.0 - i);
  EXPECT_LE((c * solve(c, VectorXcd(b)) - b).norm(), 1e-13);
  EXPECT_LE((c * solve(c, right) - right).norm(), 1e-13);
  EXPECT_LE((c * inverse(c) - MatrixXcd::Identity(3, 3)).norm(), 1e-13);
}

TEST(FactorsLu, ASingularMatrixHasNoFiniteSolution) {
  EXPECT_FALSE(solve(MatrixXd{{1, 2}, {2, 4}}, VectorXd{{1, 1}}).allFinite());
}

TEST(FactorsLu, DeterminantIsThatOfTwoByTwoByHand) {
  EXPECT_NEAR(determinant(MatrixXd{{3, 5}, {-2, 7}}), 31, 1e-13);
}

TEST(FactorsLu, FullPivotingKeepsDigitsWhereRowsDifferBy1e16) {
  const MatrixXd a{{1e-16, 1}, {1, 1}};
  const VectorXd b{{1, 2}};
  const VectorXd x = solve_full_pivot(a, b);
  EXPECT_NEAR(x(0), 1, 1e-14);
  EXPECT_NEAR(x(1), 1, 1e-14);
  EXPECT_LE((a * solve_full_pivot(a, MatrixXd(MatrixXd::Identity(2, 2))) - MatrixXd::Identity(2, 2)).norm(),
            1e-14);
}

TEST(FactorsLu, KeptFactorsSolveSeveralSidesAndKnowTheirCondition) {
  const MatrixXd a{{4, 1}, {2, 3}};
  const LuFactors factors(a);
  EXPECT_EQ(factors.solve(VectorXd{{1, 2}}), solve(a, VectorXd{{1, 2}}));
  EXPECT_LE((a * factors.solve(MatrixXd(MatrixXd::Identity(2, 2))) - MatrixXd::Identity(2, 2)).norm(), 1e-15);
  // The 1-norm is 6 for the matrix and 0.5 for its inverse.
  EXPECT_NEAR(factors.reciprocal_condition(), 1 / (6 * 0.5), 1e-12);
}

TEST(FactorsCholesky, FactorsMultiplyToTheMatrixAndSolveIt) {
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

TEST(FactorsCholesky, SaysWhereAMatrixIsNotPositiveDefinite) {
  EXPECT_FALSE(CholeskyFactors(MatrixXd{{1, 2}, {2, 1}}).positive_definite());
}

TEST(FactorsSymmetric, SolveIndefiniteMatricesToo) {
  const MatrixXd a{{1, 2, 0}, {2, 1, -3}, {0, -3, 4}}, one = MatrixXd::Identity(3, 3);
  const SymmetricFactors factors(a);
  EXPECT_LE((a * factors.solve(one) - one).norm(), 1e-14);
  const VectorXd b{{1, 2, 3}};
  EXPECT_LE((a * factors.solve(b) - b).norm(), 1e-14);
}

TEST(FactorsLeastNorm, OfManySolutionsTheShortestIsTaken) {
  // x + y = 2 twice: the solution (1, 1) is nearest to the origin.
  const MatrixXd a{{1, 1}, {1, 1}};
  EXPECT_LE((least_norm_solution(a, VectorXd{{2, 2}}) - VectorXd{{1, 1}}).norm(), 1e-15);
  EXPECT_LE((least_norm_solution(a, MatrixXd{{2, 4}, {2, 4}}) - MatrixXd{{1, 2}, {1, 2}}).norm(), 1e-15);
  EXPECT_LE((least_norm_solution(MatrixXcd(a), VectorXcd(VectorXd{{2, 2}})) - VectorXd{{1, 1}}).norm(),
            1e-15);
}

TEST(FactorsLeastNorm, WhatCannotBeMetIsMissedByTheLeastSquares) {
  // The mean has the smallest sum of squared distances from 1, 2 and 6.
  EXPECT_NEAR(least_norm_solution(MatrixXd(MatrixXd::Ones(3, 1)), VectorXd{{1, 2, 6}})(0), 3, 1e-15);
}

TEST(FactorsLeastNorm, ColumnsAreOrthonormalAndSpanWhatTheyCameFrom) {
  const MatrixXd a{{1, 2}, {0, 1}, {1, 0}};
  const MatrixXd all = orthonormal_columns(a, 3), first = all.leftCols(2);
  EXPECT_LE((all.transpose() * all - MatrixXd::Identity(3, 3)).norm(), 1e-15);
  EXPECT_LE((first * (first.transpose() * a) - a).norm(), 1e-15 * a.norm());
}

}  // namespace

}  // namespace rubsweep::numerics::dense
