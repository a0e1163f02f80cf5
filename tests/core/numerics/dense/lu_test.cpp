#include "rubsweep/core/numerics/dense/lu.hpp"

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

TEST(Lu, SolvesRealAndComplexSystems) {
  const MatrixXd a{{2, 1, 0}, {-1, 3, 4}, {0, 0.5, -1}};
  const VectorXd b{{1, -2, 3}};
  EXPECT_LE((a * solve(a, b) - b).norm(), 1e-14);
  const MatrixXcd c = a + i * MatrixXd{{0, 1, 2}, {3, 0, 1}, {1, 1, 0}};
  const MatrixXcd right = MatrixXcd::Identity(3, 3) * (2.0 - i);
  EXPECT_LE((c * solve(c, VectorXcd(b)) - b).norm(), 1e-13);
  EXPECT_LE((c * solve(c, right) - right).norm(), 1e-13);
  EXPECT_LE((c * inverse(c) - MatrixXcd::Identity(3, 3)).norm(), 1e-13);
}

TEST(Lu, ABandedMatrixIsSolvedWithinItsBand) {
  constexpr Eigen::Index size = 40;
  for (const Eigen::Index band : {1, 3, 6}) {
    MatrixXcd a = MatrixXcd::Zero(size, size);
    for (Eigen::Index row = 0; row < size; ++row) {
      for (Eigen::Index column = 0; column < size; ++column) {
        // Small numbers on the diagonal: without pivots no digit is left.
        const double number = std::sin(static_cast<double>(7 * row + 3 * column * column));
        if (std::abs(row - column) <= band)
          a(row, column) = (row == column ? 1e-14 : 1.0) * (number + i / 3.0);
      }
    }
    MatrixXcd b = MatrixXcd::Zero(size, 2);
    b(0, 0) = 1, b(size - 1, 1) = i;
    const MatrixXcd x = solve_banded(a, b, band);
    EXPECT_LE((a * x - b).norm(), 1e-11 * (1 + x.norm())) << band;
    EXPECT_LE((x - solve(a, b)).norm(), 1e-10 * x.norm()) << band;
  }
}

TEST(Lu, ASingularMatrixHasNoFiniteSolution) {
  EXPECT_FALSE(solve(MatrixXd{{1, 2}, {2, 4}}, VectorXd{{1, 1}}).allFinite());
}

TEST(Lu, DeterminantIsThatOfTwoByTwoByHand) {
  EXPECT_NEAR(determinant(MatrixXd{{3, 5}, {-2, 7}}), 31, 1e-13);
}

TEST(Lu, FullPivotingKeepsDigitsWhereRowsDifferBy1e16) {
  const MatrixXd a{{1e-16, 1}, {1, 1}};
  const VectorXd b{{1, 2}};
  const VectorXd x = solve_full_pivot(a, b);
  EXPECT_NEAR(x(0), 1, 1e-14);
  EXPECT_NEAR(x(1), 1, 1e-14);
  EXPECT_LE((a * solve_full_pivot(a, MatrixXd(MatrixXd::Identity(2, 2))) - MatrixXd::Identity(2, 2)).norm(),
            1e-14);
}

TEST(Lu, KeptFactorsSolveSeveralSidesAndKnowTheirCondition) {
  const MatrixXd a{{4, 1}, {2, 3}};
  const LuFactors factors(a);
  EXPECT_EQ(factors.solve(VectorXd{{1, 2}}), solve(a, VectorXd{{1, 2}}));
  EXPECT_LE((a * factors.solve(MatrixXd(MatrixXd::Identity(2, 2))) - MatrixXd::Identity(2, 2)).norm(), 1e-15);
  // 1-norms: 6 of the matrix, 0.5 of its inverse.
  EXPECT_NEAR(factors.reciprocal_condition(), 1 / (6 * 0.5), 1e-12);
}

}  // namespace
}  // namespace rubsweep::numerics::dense
