#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace rubsweep::branch::orbits {
namespace {

TEST(MultipliersMultiplierColumns, TheTwoLargestAndTheLargestModulus) {
  Eigen::VectorXcd multipliers(3);
  multipliers << std::complex<double>(-0.75, 1), std::complex<double>(-0.75, -1), 0.25;
  EXPECT_EQ(multiplier_columns(),
            ",multiplier_1_re,multiplier_1_im,multiplier_2_re,multiplier_2_im,floquet_modulus");
  EXPECT_EQ(multiplier_cells(multipliers), ",-0.75,1,-0.75,-1,1.25");
}

TEST(MultipliersMultiplierColumns, WhatIsNotThereIsEmpty) {
  EXPECT_EQ(multiplier_cells(Eigen::VectorXcd::Constant(1, -2)), ",-2,0,,,2");
}

/// Block-diagonal matrix: a rotation by `angle` scaled by `modulus`, and two real multipliers.
Eigen::MatrixXd blocks(double modulus, double angle, double a, double b) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
  matrix.topLeftCorner(2, 2) << modulus * std::cos(angle), -modulus * std::sin(angle),
      modulus * std::sin(angle), modulus * std::cos(angle);
  matrix(2, 2) = a;
  matrix(3, 3) = b;
  return matrix;
}

TEST(Multipliers, LargestFirstAndThePositiveOneOfAPair) {
  const auto multipliers = multipliers_of(blocks(0.9, 1, -1.5, 0.2));
  EXPECT_NEAR(multipliers(0).real(), -1.5, 1e-14);
  EXPECT_NEAR(std::arg(multipliers(1)), 1, 1e-14);
  EXPECT_NEAR(std::arg(multipliers(2)), -1, 1e-14);
  EXPECT_EQ(count_outside(multipliers), 1);
}

TEST(Multipliers, DoublingTestIsTheDeterminant) {
  const auto matrix = blocks(0.9, 1, -1.5, 0.2);
  EXPECT_NEAR(doubling_test(multipliers_of(matrix)), (matrix + Eigen::MatrixXd::Identity(4, 4)).determinant(),
              1e-13);
}

/// Closed form of this matrix: a pair on the unit circle, or two real multipliers with the product 1.
TEST(Multipliers, TorusTestChangesSignAtATorusAndAtANeutralSaddle) {
  const auto sign = [](const Eigen::MatrixXd& m) { return std::signbit(torus_test(multipliers_of(m))); };
  EXPECT_NE(sign(blocks(0.99, 1, -0.5, 0.2)), sign(blocks(1.01, 1, -0.5, 0.2)));
  EXPECT_NE(sign(blocks(0.5, 1, 1.9, 0.5)), sign(blocks(0.5, 1, 2.1, 0.5)));
  EXPECT_TRUE(nearest_pair_is_complex(multipliers_of(blocks(1.01, 1, -0.5, 0.2))));
  EXPECT_FALSE(nearest_pair_is_complex(multipliers_of(blocks(0.5, 1, 2.001, 0.5))));
}

}  // namespace
}  // namespace rubsweep::branch::orbits
