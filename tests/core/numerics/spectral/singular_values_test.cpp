#include "rubsweep/core/numerics/spectral/singular_values.hpp"

#include <gtest/gtest.h>

namespace rubsweep::numerics::spectral {
namespace {

using Eigen::MatrixXd;

TEST(SingularValues, OfARotationTimesStretchesAreTheStretches) {
  const double c = 0.6, s = 0.8;
  const MatrixXd a = MatrixXd{{c, -s}, {s, c}} * MatrixXd{{2, 0}, {0, 5}};
  const SingularValues found = singular_values(a);
  EXPECT_NEAR(found.values(0), 5, 1e-14);
  EXPECT_NEAR(found.values(1), 2, 1e-14);
  EXPECT_LE((found.u * found.values.asDiagonal() * found.v.transpose() - a).norm(), 1e-14);
}

TEST(SingularValues, LastColumnsAreNullVectorsOfASingularMatrix) {
  const MatrixXd a{{1, 2}, {2, 4}};
  const SingularValues found = singular_values(a);
  EXPECT_LE((a * found.v.col(1)).norm(), 1e-15 * a.norm());
  EXPECT_LE((a.transpose() * found.u.col(1)).norm(), 1e-15 * a.norm());
}

TEST(SingularValues, OfATallMatrixAreAsManyAsItsColumns) {
  const MatrixXd a{{3, 0}, {0, 1}, {4, 0}};
  const SingularValues found = singular_values(a);
  ASSERT_EQ(found.values.size(), 2);
  EXPECT_NEAR(found.values(0), 5, 1e-14);
  EXPECT_NEAR(found.values(1), 1, 1e-14);
  EXPECT_EQ(found.u.cols(), 2);
  EXPECT_LE((found.u * found.values.asDiagonal() * found.v.transpose() - a).norm(), 1e-14);
}

}  // namespace
}  // namespace rubsweep::numerics::spectral
