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
  // A motion as small as the noise still counts as a motion.
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
  // When the shaft moves along a line, both probes read the same motion with independent noise.
  EXPECT_TRUE(pair_findings(x, signal(30, 0, 0.01, 2)).empty());
}

/// A noisy 1/2 subharmonic with this number of readings per turn.
std::vector<double> motion(int count, double readings_per_turn, double noise, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<double> readings;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / readings_per_turn;
    readings.push_back(7 + std::cos(angle) + 0.5 * std::sin(angle / 2) + noise * normal(random));
  }
  return readings;
}

using Places = std::vector<std::size_t>;

TEST(ProbeFaultsWildReadings, AreFoundAndReplacedHoweverFarTheyAre) {
  for (const double readings_per_turn : {16.0, 40.0}) {
    for (const double jump : {1.5, -4.0, 20.0, 1e15}) {
      const auto truth = motion(160, readings_per_turn, 1e-3);
      auto readings = truth;
      readings[60] += jump;
      readings[100] -= 2 * jump;
      const WildReadings wild = replace_wild_readings(readings);
      EXPECT_EQ(wild.places, (Places{60, 100})) << readings_per_turn << ' ' << jump;
      EXPECT_TRUE(wild.replaced);
      for (const std::size_t k : wild.places) EXPECT_NEAR(readings[k], truth[k], 0.02);
      readings[60] = truth[60];
      readings[100] = truth[100];
      EXPECT_EQ(readings, truth);
    }
  }
}

TEST(ProbeFaultsWildReadings, ThreeInARow) {
  const auto truth = motion(600, 40, 1e-3);
  auto readings = truth;
  for (std::size_t k = 200; k < 203; ++k) readings[k] = 50;
  EXPECT_EQ(replace_wild_readings(readings).places, (Places{200, 201, 202}));
  for (std::size_t k = 200; k < 203; ++k) EXPECT_NEAR(readings[k], truth[k], 0.02);
}

TEST(ProbeFaultsWildReadings, AMotionHasNone) {
  for (const double readings_per_turn : {2.9, 5.37, 8.0, 20.0, 71.0}) {
    for (const double noise : {0.0, 1e-2, 0.3, 3.0}) {
      const auto truth = motion(2000, readings_per_turn, noise);
      auto readings = truth;
      EXPECT_TRUE(replace_wild_readings(readings).places.empty()) << readings_per_turn << ' ' << noise;
      EXPECT_EQ(readings, truth);
    }
  }
}

TEST(ProbeFaultsWildReadings, AShortLargeMotionAndBouncesAreNone) {
  std::vector<double> resonance, bounces, square;
  for (int k = 0; k < 4000; ++k) {
    resonance.push_back(std::sin(0.9 * k) * (1 + 40 * std::exp(-std::pow((k - 2000) / 60.0, 2))));
    const double x = std::fmod(0.1 * k, 2) - 1;
    bounces.push_back(1 - x * x);
    square.push_back(k % 14 < 4 ? 1 : k % 14 < 8 ? 0 : -1);
  }
  EXPECT_TRUE(replace_wild_readings(resonance).places.empty());
  EXPECT_TRUE(replace_wild_readings(bounces).places.empty());
  EXPECT_TRUE(replace_wild_readings(square).places.empty());
}

TEST(ProbeFaultsWildReadings, ASignalOfSpikesIsLeftAsItIs) {
  auto readings = motion(1000, 40, 1e-3);
  for (std::size_t k = 5; k < readings.size(); k += 20) readings[k] += 30;
  const auto before = readings;
  const WildReadings wild = replace_wild_readings(readings);
  EXPECT_FALSE(wild.replaced);
  EXPECT_EQ(wild.places.size(), 50u);
  EXPECT_EQ(readings, before);
}

TEST(ProbeFaultsWildReadings, GapsArePassedOver) {
  auto readings = motion(400, 40, 1e-3);
  readings[50] = NAN;
  readings[200] = 90;
  EXPECT_EQ(replace_wild_readings(readings).places, Places{200});
  EXPECT_TRUE(std::isnan(readings[50]));
}

}  // namespace
}  // namespace rubsweep::recording
