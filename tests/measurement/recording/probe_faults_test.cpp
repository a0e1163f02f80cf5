#include "rubsweep/measurement/recording/probe_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::recording {
namespace {

constexpr int readings_per_turn = 40;

std::vector<double> signal(int turns, double phase, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(turns) * readings_per_turn);
  for (int k = 0; k < turns * readings_per_turn; ++k)
    values.push_back(std::cos(2 * std::numbers::pi * k / readings_per_turn + phase) + noise * normal(random));
  return values;
}

TEST(ProbeFaults, AProbeThatSticks) {
  const auto other = signal(30, 1, 0.01, 1);
  auto values = signal(30, 0, 0.01, 2);
  EXPECT_FALSE(still_stretch(values, other, readings_per_turn));
  for (std::size_t k = 600; k < 900; ++k) values[k] = values[600];
  const auto still = still_stretch(values, other, readings_per_turn);
  ASSERT_TRUE(still);
  EXPECT_NEAR(static_cast<double>(still->first), 600, 6);
  EXPECT_NEAR(static_cast<double>(still->first + still->count), 900, 6);
  EXPECT_TRUE(still_stretch(values, {}, readings_per_turn));
}

TEST(ProbeFaults, AProbeWhoseCableBreaksShowsALittleNoise) {
  const auto other = signal(30, 1, 0.01, 1);
  auto values = signal(30, 0, 0.003, 2);
  for (std::size_t k = 600; k < values.size(); ++k) values[k] = 0.002 * std::sin(static_cast<double>(k * k));
  const auto still = still_stretch(values, other, readings_per_turn);
  ASSERT_TRUE(still);
  EXPECT_NEAR(static_cast<double>(still->first), 600, 6);
  EXPECT_EQ(still->first + still->count, values.size());
}

TEST(ProbeFaults, ARotorThatRestsSticksInNoProbe) {
  auto x = signal(30, 1, 0.01, 1), y = signal(30, 0, 0.01, 2);
  for (std::size_t k = 600; k < x.size(); ++k) x[k] = y[k] = 0;
  EXPECT_FALSE(still_stretch(x, y, readings_per_turn));
}

std::vector<std::string> pair_findings(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<std::string> findings;
  add_pair_findings({"X", x}, {"Y", y}, findings);
  return findings;
}

TEST(ProbeFaults, NoiseAloneBesideAMotion) {
  const auto x = signal(30, 0, 0.01, 1);
  auto noise = signal(30, 0, 0.02, 2);
  const auto clean = signal(30, 0, 0, 2);
  for (std::size_t k = 0; k < noise.size(); ++k) noise[k] -= clean[k];
  ASSERT_EQ(pair_findings(x, noise).size(), 1u);
  EXPECT_TRUE(pair_findings(x, noise)[0].starts_with("'Y' shows noise alone where 'X' sees a motion"));
  EXPECT_TRUE(pair_findings(noise, x)[0].starts_with("'X' shows noise alone"));
  auto other_noise = noise;
  std::reverse(other_noise.begin(), other_noise.end());
  EXPECT_TRUE(pair_findings(noise, other_noise).empty());
  EXPECT_TRUE(pair_findings(x, signal(30, 1.6, 0.01, 3)).empty());
  // A motion as large as the noise is one.
  auto weak = noise;
  for (std::size_t k = 0; k < weak.size(); ++k) weak[k] += 0.02 * clean[k];
  EXPECT_TRUE(pair_findings(x, weak).empty());
}

TEST(ProbeFaults, OneSignalTwice) {
  const auto x = signal(30, 0, 0.01, 1);
  auto y = x;
  ASSERT_EQ(pair_findings(x, y).size(), 1u);
  EXPECT_TRUE(pair_findings(x, y)[0].starts_with("'X' and 'Y' read the same signal"));
  for (double& value : y) value = 3 - 0.5 * value;
  EXPECT_EQ(pair_findings(x, y).size(), 1u);
  // A motion along a line has noise of its own in each probe.
  EXPECT_TRUE(pair_findings(x, signal(30, 0, 0.01, 2)).empty());
}

}  // namespace
}  // namespace rubsweep::recording
