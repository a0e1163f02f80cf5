#include "rubsweep/measurement/fit/uncertainty.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

/// A fit of a straight line a + b t at t = 0 .. 9 with residuals +1, -1, ...
LeastSquaresFit line() {
  LeastSquaresFit fit;
  fit.value = Eigen::Vector2d(1, 2);
  fit.jacobian.resize(10, 2);
  fit.residuals.resize(10);
  for (Eigen::Index k = 0; k < 10; ++k) {
    fit.jacobian.row(k) << 1, static_cast<double>(k);
    fit.residuals(k) = k % 2 == 0 ? 1 : -1;
  }
  return fit;
}

TEST(Uncertainty, AStraightLineHasTheErrorsOfTextbooks) {
  const Uncertainty found = uncertainty_of(line(), 0);
  const double variance = 10.0 / 8, spread = 82.5;
  EXPECT_EQ(found.degrees_of_freedom, 8);
  EXPECT_NEAR(found.standard_error(1), std::sqrt(variance / spread), 1e-12);
  EXPECT_NEAR(found.standard_error(0), std::sqrt(variance * (0.1 + 4.5 * 4.5 / spread)), 1e-12);
  EXPECT_NEAR(found.correlation(0, 1), -4.5 / std::sqrt(28.5), 1e-12);
  EXPECT_NEAR(found.half_width(1) / found.standard_error(1), 2.3060, 1e-4);  // eight degrees of freedom
  EXPECT_THROW(uncertainty_of(line(), 8), ConfigError);
  EXPECT_TRUE(untold_combinations(found, {{"a"}, {"b"}}).empty());
}

TEST(Uncertainty, CombinationsThatDataDoNotTellAreNamed) {
  LeastSquaresFit fit = line();
  fit.value = Eigen::Vector3d(1, 2, 3);
  fit.jacobian.conservativeResize(10, 3);
  fit.jacobian.col(2) = 5 * fit.jacobian.col(1);
  const auto sentences = untold_combinations(uncertainty_of(fit, 0), {{"a"}, {"b"}, {"c"}});
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("b, c"), std::string::npos);
  fit.jacobian.col(2).setZero();
  const auto alone =
      untold_combinations(uncertainty_of(fit, 0), {{"a", 1, 0, 9}, {"b", 2, 0, 9}, {"c", 3, 0, 9}});
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0], "the data do not tell c");
  fit = line();
  const auto narrow = untold_combinations(uncertainty_of(fit, 0), {{"a", 1, 0, 9}, {"b", 2, 1.99, 2.01}});
  EXPECT_EQ(narrow, std::vector<std::string>{"the data do not tell b"});
}

constexpr Eigen::Index instants = 120;

/// A constant and a short bump fitted to noise with the correlation `r` of neighbours, in two identical rows.
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

/// Share of 400 fits whose interval for the bump contains the true value 0.
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

TEST(Uncertainty, IntervalsHoldTheTruthWhereNeighboursHangTogether) {
  EXPECT_LT(coverage(0.7, false), 0.6) << "white noise would be believed";
  EXPECT_GT(coverage(0.7, true), 0.9);
  EXPECT_GT(coverage(0, true), 0.93);
}

TEST(Uncertainty, BlocksAreAsLongAsResidualsHangTogether) {
  std::mt19937_64 random(2);
  const RowsInTime rows{0, instants, 2};
  EXPECT_LT(block_length(bump_in_noise(0.1, random).residuals, rows), 8);
  EXPECT_GT(block_length(bump_in_noise(0.8, random).residuals, rows), 9);
  EXPECT_EQ(block_length(bump_in_noise(0.99, random).residuals, rows), instants / 10);
}

TEST(Uncertainty, FewInstantsTellNothing) {
  std::mt19937_64 random(3);
  const LeastSquaresFit fit = bump_in_noise(0.7, random);
  const Uncertainty before = uncertainty_of(fit, 0);
  Uncertainty after = before;
  allow_for_correlation(fit, {{0, 20, 1}}, after);
  EXPECT_EQ(after.half_width, before.half_width);
  allow_for_correlation(fit, {}, after);
  EXPECT_EQ(after.half_width, before.half_width);
}

std::vector<double> white_noise(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 2);
  std::vector<double> values(300);
  for (double& value : values) value = normal(random);
  return values;
}

TEST(UncertaintyResidualTest, NoiseIsWhite) {
  int alarms = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) alarms += !test_residuals(white_noise(seed)).white;
  // Two tests with a false-alarm rate of 1 % each.
  EXPECT_LE(alarms, 10);
}

TEST(UncertaintyResidualTest, AWeakVibrationIsFoundWithItsFrequency) {
  auto values = white_noise(1);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] += 1.2 * std::cos(2 * std::numbers::pi * 0.12 * static_cast<double>(k));
  const ResidualTest test = test_residuals(values);
  EXPECT_FALSE(test.white);
  EXPECT_TRUE(test.line_stands_out);
  EXPECT_NEAR(test.line, 0.12, 0.002);
}

TEST(UncertaintyResidualTest, NeighboursThatHangTogetherAreNoNoise) {
  auto values = white_noise(2);
  for (std::size_t k = 1; k < values.size(); ++k) values[k] += 0.6 * values[k - 1];
  const ResidualTest test = test_residuals(values);
  EXPECT_FALSE(test.white);
  EXPECT_NEAR(test.first_correlation, 0.6, 0.12);
}

TEST(UncertaintyResidualTest, FewResidualsTellNothing) {
  EXPECT_TRUE(test_residuals(std::vector<double>{1, 2, 3}).white);
}

}  // namespace
}  // namespace rubsweep::fit
