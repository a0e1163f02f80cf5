#include "rubsweep/fit/correlated_noise.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace rubsweep::fit {
namespace {

constexpr Eigen::Index instants = 120;

/// A constant and a bump of some instants, fitted to noise whose neighbours correlate by `r`, in two rows
/// that read the same.
LeastSquaresFit bump_in_noise(double r, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  LeastSquaresFit fit;
  fit.jacobian.resize(2 * instants, 2);
  Eigen::VectorXd noise(2 * instants);
  double last = normal(random);
  for (Eigen::Index k = 0; k < instants; ++k) {
    const double off = static_cast<double>(k - 40) / 8;
    for (const Eigen::Index row : {k, instants + k}) {
      fit.jacobian.row(row) << 1, std::exp(-off * off);
      noise(row) = last;
    }
    last = r * last + std::sqrt(1 - r * r) * normal(random);
  }
  fit.value = (fit.jacobian.transpose() * fit.jacobian).inverse() * fit.jacobian.transpose() * noise;
  fit.residuals = noise - fit.jacobian * fit.value;
  return fit;
}

/// Share of 400 fits whose intervals hold the truth, 0, of the bump.
double coverage(double r, bool allowed_for) {
  std::mt19937_64 random(5);
  constexpr int trials = 400;
  int inside = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const LeastSquaresFit fit = bump_in_noise(r, random);
    Uncertainty found = uncertainty_of(fit, 0);
    if (allowed_for) allow_for_correlation(fit, {{0, instants, 2}}, found);
    inside += std::abs(fit.value(1)) <= found.half_width(1);
  }
  return static_cast<double>(inside) / trials;
}

TEST(CorrelatedNoise, IntervalsHoldTheTruthWhereNeighboursHangTogether) {
  EXPECT_LT(coverage(0.7, false), 0.6) << "white noise would be believed";
  EXPECT_GT(coverage(0.7, true), 0.9);
  EXPECT_GT(coverage(0, true), 0.93);
}

TEST(CorrelatedNoise, BlocksAreAsLongAsResidualsHangTogether) {
  std::mt19937_64 random(2);
  const RowsInTime rows{0, instants, 2};
  EXPECT_LT(block_length(bump_in_noise(0.1, random).residuals, rows), 8);
  EXPECT_GT(block_length(bump_in_noise(0.8, random).residuals, rows), 9);
  EXPECT_EQ(block_length(bump_in_noise(0.99, random).residuals, rows), instants / 10);
}

TEST(CorrelatedNoise, FewInstantsTellNothing) {
  std::mt19937_64 random(3);
  const LeastSquaresFit fit = bump_in_noise(0.7, random);
  const Uncertainty before = uncertainty_of(fit, 0);
  Uncertainty after = before;
  allow_for_correlation(fit, {{0, 20, 1}}, after);
  EXPECT_EQ(after.half_width, before.half_width);
  allow_for_correlation(fit, {}, after);
  EXPECT_EQ(after.half_width, before.half_width);
}

}  // namespace
}  // namespace rubsweep::fit
