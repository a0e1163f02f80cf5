#include "rubsweep/core/numerics/spectral/decompositions.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace rubsweep::numerics::spectral {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;

TEST(DecompositionsHermitian, AMassMatrixDividesTheSquares) {
  const MatrixXd stiffness{{2, -1}, {-1, 2}};
  EXPECT_NEAR(generalized_eigenvalues(stiffness, MatrixXd(4 * MatrixXd::Identity(2, 2)))(0), 0.25, 1e-15);
}

TEST(DecompositionsHermitian, AHermitianMatrixHasRealValues) {
  const std::complex<double> i(0, 1);
  const auto modes = hermitian_modes(MatrixXcd{{0, -i}, {i, 0}});
  ASSERT_TRUE(modes.converged);
  EXPECT_NEAR(modes.values(0), -1, 1e-15);
  EXPECT_NEAR(modes.values(1), 1, 1e-15);
}

TEST(DecompositionsHermitian, UnitaryColumnsSpanWhatTheyCameFrom) {
  const MatrixXcd a = MatrixXd{{1, 2}, {0, 1}, {1, 0}} * std::complex<double>(0, 1);
  const MatrixXcd turned = unitary_columns(a, 2);
  EXPECT_LE((turned.adjoint() * turned - MatrixXcd::Identity(2, 2)).norm(), 1e-15);
  EXPECT_LE((turned * (turned.adjoint() * a) - a).norm(), 1e-15 * a.norm());
}

TEST(DecompositionsSingularValues, OfARotationTimesStretchesAreTheStretches) {
  const double c = 0.6, s = 0.8;
  const MatrixXd a = MatrixXd{{c, -s}, {s, c}} * MatrixXd{{2, 0}, {0, 5}};
  const SingularValues found = singular_values(a);
  EXPECT_NEAR(found.values(0), 5, 1e-14);
  EXPECT_NEAR(found.values(1), 2, 1e-14);
  EXPECT_LE((found.u * found.values.asDiagonal() * found.v.transpose() - a).norm(), 1e-14);
}

TEST(DecompositionsSingularValues, LastColumnsAreNullVectorsOfASingularMatrix) {
  const MatrixXd a{{1, 2}, {2, 4}};
  const SingularValues found = singular_values(a);
  EXPECT_LE((a * found.v.col(1)).norm(), 1e-15 * a.norm());
  EXPECT_LE((a.transpose() * found.u.col(1)).norm(), 1e-15 * a.norm());
}

TEST(DecompositionsSingularValues, OfATallMatrixAreAsManyAsItsColumns) {
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
