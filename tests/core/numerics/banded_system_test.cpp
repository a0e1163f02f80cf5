#include "rubsweep/core/numerics/banded_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::numerics {
namespace {

using Eigen::MatrixXcd;

constexpr std::complex<double> i{0, 1};

TEST(BandedSystem, ABandedMatrixIsSolvedWithinItsBand) {
  constexpr Eigen::Index size = 40;
  for (const Eigen::Index band : {1, 3, 6}) {
    MatrixXcd a = MatrixXcd::Zero(size, size);
    for (Eigen::Index row = 0; row < size; ++row) {
      for (Eigen::Index column = 0; column < size; ++column) {
        // Small numbers on the diagonal: without pivoting the solution has no correct digit.
        const double number = std::sin(static_cast<double>(7 * row + 3 * column * column));
        if (std::abs(row - column) <= band)
          a(row, column) = (row == column ? 1e-14 : 1.0) * (number + i / 3.0);
      }
    }
    MatrixXcd b = MatrixXcd::Zero(size, 2);
    b(0, 0) = 1, b(size - 1, 1) = i;
    const MatrixXcd x = solve_banded(a, b, band);
    EXPECT_LE((a * x - b).norm(), 1e-11 * (1 + x.norm())) << band;
    EXPECT_LE((x - dense::solve(a, b)).norm(), 1e-10 * x.norm()) << band;
  }
}

/// Sizes that are no multiple of a register's, and a band as wide as the matrix, which structural damping of
/// all modes causes.
TEST(BandedSystem, AFullMatrixIsSolvedAsABandOfItsOwnWidth) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto any = [&](Eigen::Index rows, Eigen::Index columns) {
    MatrixXcd matrix(rows, columns);
    for (std::complex<double>& number : matrix.reshaped()) number = {normal(random), normal(random)};
    return matrix;
  };
  for (const Eigen::Index size : {1, 2, 5, 19, 66}) {
    const MatrixXcd a = any(size, size), b = any(size, 3), x = solve_banded(a, b, size - 1);
    EXPECT_LE((x - dense::solve(a, b)).norm(), 1e-11 * x.norm()) << size;
    EXPECT_LE((a * x - b).norm(), 1e-12 * (b.norm() + x.norm()) * static_cast<double>(size)) << size;
  }
  EXPECT_FALSE(solve_banded(MatrixXcd::Ones(3, 3), MatrixXcd::Ones(3, 1), 2).allFinite());
}

TEST(BandedSystem, TheBandReachesTheFarthestNumberOfAll) {
  Eigen::MatrixXd above = Eigen::MatrixXd::Identity(6, 6), below = Eigen::MatrixXd::Zero(6, 6);
  const Eigen::MatrixXd none;
  EXPECT_EQ(band_of({&above, &none}), 0);
  above(1, 3) = -1, below(5, 2) = 1e-300;
  EXPECT_EQ(band_of({&above, &none}), 2);
  EXPECT_EQ(band_of({&above, &below}), 3);
}

}  // namespace
}  // namespace rubsweep::numerics
