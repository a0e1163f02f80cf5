#include "rubsweep/numerics/dense/orthonormal.hpp"

#include <gtest/gtest.h>

namespace rubsweep::numerics::dense {
namespace {

using Eigen::MatrixXd;

TEST(Orthonormal, ColumnsAreOrthonormalAndSpanWhatTheyCameFrom) {
  const MatrixXd a{{1, 2}, {0, 1}, {1, 0}};
  const MatrixXd all = orthonormal_columns(a, 3), first = all.leftCols(2);
  EXPECT_LE((all.transpose() * all - MatrixXd::Identity(3, 3)).norm(), 1e-15);
  EXPECT_LE((first * (first.transpose() * a) - a).norm(), 1e-15 * a.norm());
}

}  // namespace
}  // namespace rubsweep::numerics::dense
