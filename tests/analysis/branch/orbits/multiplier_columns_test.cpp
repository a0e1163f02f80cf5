#include "rubsweep/analysis/branch/orbits/multiplier_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

namespace rubsweep::branch::orbits {
namespace {

TEST(MultiplierColumns, TheTwoLargestAndTheLargestModulus) {
  Eigen::VectorXcd multipliers(3);
  multipliers << std::complex<double>(-0.75, 1), std::complex<double>(-0.75, -1), 0.25;
  EXPECT_EQ(multiplier_columns(),
            ",multiplier_1_re,multiplier_1_im,multiplier_2_re,multiplier_2_im,floquet_modulus");
  EXPECT_EQ(multiplier_cells(multipliers), ",-0.75,1,-0.75,-1,1.25");
}

TEST(MultiplierColumns, WhatIsNotThereIsEmpty) {
  EXPECT_EQ(multiplier_cells(Eigen::VectorXcd::Constant(1, -2)), ",-2,0,,,2");
}

}  // namespace
}  // namespace rubsweep::branch::orbits
