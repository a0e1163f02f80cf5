#include "rubsweep/core/numerics/dense/least_norm.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace rubsweep::numerics::dense {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

TEST(LeastNorm, OfManySolutionsTheShortestIsTaken) {
  // x + y = 2 twice: (1, 1) is nearest to the origin.
  const MatrixXd a{{1, 1}, {1, 1}};
  EXPECT_LE((least_norm_solution(a, VectorXd{{2, 2}}) - VectorXd{{1, 1}}).norm(), 1e-15);
  EXPECT_LE((least_norm_solution(a, MatrixXd{{2, 4}, {2, 4}}) - MatrixXd{{1, 2}, {1, 2}}).norm(), 1e-15);
  EXPECT_LE((least_norm_solution(MatrixXcd(a), VectorXcd(VectorXd{{2, 2}})) - VectorXd{{1, 1}}).norm(),
            1e-15);
}

TEST(LeastNorm, WhatCannotBeMetIsMissedByTheLeastSquares) {
  // The mean is nearest to 1, 2 and 6.
  EXPECT_NEAR(least_norm_solution(MatrixXd(MatrixXd::Ones(3, 1)), VectorXd{{1, 2, 6}})(0), 3, 1e-15);
}

TEST(LeastNorm, ColumnsAreOrthonormalAndSpanWhatTheyCameFrom) {
  const MatrixXd a{{1, 2}, {0, 1}, {1, 0}};
  const MatrixXd all = orthonormal_columns(a, 3), first = all.leftCols(2);
  EXPECT_LE((all.transpose() * all - MatrixXd::Identity(3, 3)).norm(), 1e-15);
  EXPECT_LE((first * (first.transpose() * a) - a).norm(), 1e-15 * a.norm());
}

}  // namespace
}  // namespace rubsweep::numerics::dense
