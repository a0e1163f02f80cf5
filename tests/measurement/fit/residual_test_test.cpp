#include "rubsweep/measurement/fit/residual_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::fit {
namespace {

std::vector<double> white_noise(unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 2);
  std::vector<double> values(300);
  for (double& value : values) value = normal(random);
  return values;
}

TEST(ResidualTest, NoiseIsWhite) {
  int alarms = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) alarms += !test_residuals(white_noise(seed)).white;
  // Two tests of one per cent each.
  EXPECT_LE(alarms, 10);
}

TEST(ResidualTest, AWeakVibrationIsFoundWithItsFrequency) {
  auto values = white_noise(1);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] += 1.2 * std::cos(2 * std::numbers::pi * 0.12 * static_cast<double>(k));
  const ResidualTest test = test_residuals(values);
  EXPECT_FALSE(test.white);
  EXPECT_TRUE(test.line_stands_out);
  EXPECT_NEAR(test.line, 0.12, 0.002);
}

TEST(ResidualTest, NeighboursThatHangTogetherAreNoNoise) {
  auto values = white_noise(2);
  for (std::size_t k = 1; k < values.size(); ++k) values[k] += 0.6 * values[k - 1];
  const ResidualTest test = test_residuals(values);
  EXPECT_FALSE(test.white);
  EXPECT_NEAR(test.first_correlation, 0.6, 0.12);
}

TEST(ResidualTest, FewResidualsTellNothing) {
  EXPECT_TRUE(test_residuals(std::vector<double>{1, 2, 3}).white);
}

}  // namespace
}  // namespace rubsweep::fit
