#include "rubsweep/measurement/scope/line_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;

constexpr int turns_looked_at = 48, readings_per_turn = 64;

/// Lines of white noise of standard deviation 1 in each component, and of a circle of the given order.
Lines noisy_lines(unsigned seed, double order = 0, double radius = 0,
                  recording::Integration integration = {}) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 1);
  std::vector<Complex> z(turns_looked_at * readings_per_turn);
  for (std::size_t k = 0; k < z.size(); ++k) {
    const double angle = 2 * std::numbers::pi * order * static_cast<double>(k) / readings_per_turn;
    z[k] = std::polar(radius, angle) + Complex(noise(random), noise(random));
  }
  response::spectrum::SpectrumWorkspace workspace;
  return {response::spectrum::full_spectrum(z, turns_looked_at, workspace), 8, 5e-3, integration};
}

/// White noise of n readings leaves its standard deviation / sqrt(n) in each component of a line.
const double true_noise = 1 / std::sqrt(1.0 * turns_looked_at * readings_per_turn);

TEST(LineNoise, IsThatOfWhiteNoiseBesideALargeLine) {
  double sum = 0;
  constexpr int trials = 40;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const Threshold threshold = threshold_of(noisy_lines(seed, 1, 50));
    sum += threshold.noise_m / true_noise;
    EXPECT_NEAR(threshold.largest_m, 50, 0.2);
    EXPECT_NEAR(threshold.floor_m, 0.25, 1e-3);
    EXPECT_EQ(threshold.visible_m(), threshold.floor_m);
  }
  EXPECT_NEAR(sum / trials, 1, 0.02);
}

TEST(LineNoise, ReachesItsThresholdsAsRarelyAsTheySay) {
  int suspicious = 0, seen = 0;
  constexpr int trials = 1000;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const Threshold threshold = threshold_of(noisy_lines(seed));
    suspicious += threshold.largest_m > threshold.suspicious_m;
    seen += threshold.largest_m > threshold.seen_m;
  }
  // Four binomial standard deviations about 1 - exp(-0.2) and 1 %.
  EXPECT_NEAR(suspicious, trials * (1 - std::exp(-0.2)), 4 * std::sqrt(trials * 0.18 * 0.82));
  EXPECT_NEAR(seen, trials * 0.01, 4 * std::sqrt(trials * 0.01));
}

TEST(LineNoise, OfIntegratedReadingsFallsWithTheOrder) {
  const recording::Integration twice{.times = 2, .lowest_order = 0.125};
  const Lines lines = noisy_lines(1, 0.5, 0, twice);
  EXPECT_NEAR(threshold_of(lines).noise_m, true_noise, 0.1 * true_noise);
  EXPECT_DOUBLE_EQ(lines.noise_at(turns_looked_at / 2), 4);
  EXPECT_DOUBLE_EQ(lines.noise_at(-2 * turns_looked_at), 0.25);
}

TEST(LineNoise, LinesBesideAPeriodStandOutOrNot) {
  const Lines lines = noisy_lines(3, -2.0 / 3, 1);
  const Threshold threshold = threshold_of(lines);
  EXPECT_TRUE(is_visible_beside(lines, 1, threshold));
  EXPECT_TRUE(is_visible_beside(lines, 2, threshold));
  EXPECT_FALSE(is_visible_beside(lines, 3, threshold));
  EXPECT_NEAR(highest_beside(lines, 1).amplitude_m, 1, 5 * true_noise);
  EXPECT_NEAR(highest_beside(lines, 1, 3).amplitude_m, 1, 5 * true_noise);
  EXPECT_LT(highest_beside(lines, 1, 2).amplitude_m, 5 * true_noise);
  EXPECT_LT(highest_beside(lines, 3).amplitude_m, threshold.seen_m);
}

TEST(LineNoise, PeriodsAreFoundInThreeRepetitions) {
  EXPECT_EQ(longest_period_in(5), 1);
  EXPECT_EQ(longest_period_in(6), 2);
  EXPECT_EQ(longest_period_in(24), 8);
  EXPECT_EQ(longest_period_in(1000), 8);
}

}  // namespace
}  // namespace rubsweep::scope
