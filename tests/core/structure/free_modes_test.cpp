#include "rubsweep/core/structure/free_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "rubsweep/core/error.hpp"

namespace rubsweep::structure {
namespace {

using Complex = std::complex<double>;

/// Independent masses of 2 kg, each on a spring and damper to the ground, so that each has its own
/// eigenvalues.
SpeedMatrices side_by_side(const Eigen::VectorXd& stiffness, double damping = 4) {
  const Eigen::Index n = stiffness.size();
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(n, n);
  return {2 * one, damping * one, stiffness.asDiagonal()};
}

/// Eigenvalue of a single mass, with positive imaginary part.
Complex root_of(double stiffness, double damping = 4) {
  return {-damping / 4, std::sqrt(stiffness / 2 - damping * damping / 16)};
}

Eigen::Index times(const Eigen::VectorXcd& rates, Complex root) {
  return std::ranges::count_if(
      rates, [&](const Complex& rate) { return std::abs(rate - root) <= 1e-11 * std::abs(root); });
}

TEST(FreeModes, InADiscAreAllAndNoOthers) {
  const SpeedMatrices matrices = side_by_side(Eigen::Vector4d{1e4, 4e4, 4e4, 1e8});
  const FreeModes modes = free_modes(matrices, {0, 1000});
  EXPECT_EQ(modes.rate_per_s.size(), 6);  // conjugates and a double one count; 7071 1/s is out of range
  for (const Complex root : {root_of(1e4), std::conj(root_of(1e4))})
    EXPECT_EQ(times(modes.rate_per_s, root), 1);
  EXPECT_EQ(times(modes.rate_per_s, root_of(4e4)), 2);
  for (Eigen::Index k = 0; k < modes.rate_per_s.size(); ++k) {
    const Complex s = modes.rate_per_s(k);
    const Eigen::VectorXcd shape = modes.shape.col(k);
    EXPECT_NEAR(shape.norm(), 1, 1e-12);
    const Eigen::VectorXcd rest =
        s * s * (matrices.mass * shape) + s * (matrices.damping * shape) + matrices.stiffness * shape;
    EXPECT_LE(rest.norm(), 1e-10 * std::norm(s));
  }
}

TEST(FreeModes, OfADiscAsideAreThoseAboutItsCentre) {
  // Overdamped: both roots are real, -26.8 and -3732 1/s.
  const SpeedMatrices matrices = side_by_side(Eigen::VectorXd::Constant(1, 2e5), 7517.6);
  const Eigen::VectorXcd rates = free_modes(matrices, {-3700, 100}).rate_per_s;
  ASSERT_EQ(rates.size(), 1);
  const double b = 7517.6 / 4;
  EXPECT_NEAR(rates(0).real(), -b - std::sqrt(b * b - 1e5), 1e-8);
}

TEST(FreeModes, ACoordinateWithoutMassHasNone) {
  SpeedMatrices matrices = side_by_side(Eigen::Vector2d{1e4, 3e4});
  matrices.mass(1, 1) = matrices.damping(1, 1) = 0;
  matrices.stiffness(0, 1) = matrices.stiffness(1, 0) = -1e4;  // second spring in series
  const Complex root = root_of(1e4 - 1e8 / 3e4);
  EXPECT_EQ(free_modes(matrices, {0, 1e3}).rate_per_s.size(), 2);
  EXPECT_EQ(times(free_modes(matrices, {0, 1e3}).rate_per_s, root), 1);
  EXPECT_EQ(times(all_rates_per_s(matrices, 1e3), root), 1);
}

TEST(FreeModes, AFreeMassIsNoVibrationAboutRateZero) {
  EXPECT_THROW(free_modes(side_by_side(Eigen::Vector2d{0, 1e4}, 0), {0, 1e3}), SolverError);
}

TEST(FreeModes, AllRatesHaveTheFastOnesToo) {
  const Eigen::VectorXcd rates = all_rates_per_s(side_by_side(Eigen::Vector3d{1e4, 4e4, 1e8}), 200);
  EXPECT_EQ(rates.size(), 6);
  for (const double stiffness : {1e4, 4e4, 1e8}) EXPECT_EQ(times(rates, root_of(stiffness)), 1);
}

TEST(FreeModes, AreFollowedToOtherMatrices) {
  Complex rate = root_of(1e4);
  Eigen::VectorXcd shape = Eigen::Vector2cd(1, 1e-3);
  ASSERT_TRUE(follow_free_mode(side_by_side(Eigen::Vector2d{1.3e4, 9e4}, 10), rate, shape));
  EXPECT_LE(std::abs(rate - root_of(1.3e4, 10)), 1e-12 * std::abs(rate));
  EXPECT_LE(std::abs(shape(1)), 1e-12);
}

TEST(FreeModes, RoundingOfTheMatricesIsBoundedAndSmall) {
  const SpeedMatrices matrices = side_by_side(Eigen::Vector2d{1e4, 4e4}, 0);
  const FreeModes modes = free_modes(matrices, {0, 1000});
  for (Eigen::Index k = 0; k < modes.rate_per_s.size(); ++k) {
    const double bound = rate_rounding_per_s(matrices, modes.rate_per_s(k), modes.shape.col(k));
    EXPECT_LE(std::abs(modes.rate_per_s(k).real()), bound);
    EXPECT_LE(bound, 1e-11);
    EXPECT_GT(bound, 0);
  }
}

}  // namespace
}  // namespace rubsweep::structure
