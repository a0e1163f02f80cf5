#include "rubsweep/core/numerics/spectral/hermitian.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace rubsweep::numerics::spectral {
namespace {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;

TEST(Hermitian, AMassMatrixDividesTheSquares) {
  const MatrixXd stiffness{{2, -1}, {-1, 2}};
  EXPECT_NEAR(generalized_eigenvalues(stiffness, MatrixXd(4 * MatrixXd::Identity(2, 2)))(0), 0.25, 1e-15);
}

TEST(Hermitian, AHermitianMatrixHasRealValues) {
  const std::complex<double> i(0, 1);
  const auto modes = hermitian_modes(MatrixXcd{{0, -i}, {i, 0}});
  ASSERT_TRUE(modes.converged);
  EXPECT_NEAR(modes.values(0), -1, 1e-15);
  EXPECT_NEAR(modes.values(1), 1, 1e-15);
}

TEST(Hermitian, UnitaryColumnsSpanWhatTheyCameFrom) {
  const MatrixXcd a = MatrixXd{{1, 2}, {0, 1}, {1, 0}} * std::complex<double>(0, 1);
  const MatrixXcd turned = unitary_columns(a, 2);
  EXPECT_LE((turned.adjoint() * turned - MatrixXcd::Identity(2, 2)).norm(), 1e-15);
  EXPECT_LE((turned * (turned.adjoint() * a) - a).norm(), 1e-15 * a.norm());
}

}  // namespace
}  // namespace rubsweep::numerics::spectral
