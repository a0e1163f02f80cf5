#include "rubsweep/measurement/recording/wild_readings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::recording {
namespace {

/// A 1/2 motion of so many readings a turn, with noise.
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

TEST(WildReadings, AreFoundAndReplacedHoweverFarTheyAre) {
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

TEST(WildReadings, ThreeInARow) {
  const auto truth = motion(600, 40, 1e-3);
  auto readings = truth;
  for (std::size_t k = 200; k < 203; ++k) readings[k] = 50;
  EXPECT_EQ(replace_wild_readings(readings).places, (Places{200, 201, 202}));
  for (std::size_t k = 200; k < 203; ++k) EXPECT_NEAR(readings[k], truth[k], 0.02);
}

TEST(WildReadings, AMotionHasNone) {
  for (const double readings_per_turn : {2.9, 5.37, 8.0, 20.0, 71.0}) {
    for (const double noise : {0.0, 1e-2, 0.3, 3.0}) {
      const auto truth = motion(2000, readings_per_turn, noise);
      auto readings = truth;
      EXPECT_TRUE(replace_wild_readings(readings).places.empty()) << readings_per_turn << ' ' << noise;
      EXPECT_EQ(readings, truth);
    }
  }
}

TEST(WildReadings, AShortLargeMotionAndBouncesAreNone) {
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

TEST(WildReadings, ASignalOfSpikesIsLeftAsItIs) {
  auto readings = motion(1000, 40, 1e-3);
  for (std::size_t k = 5; k < readings.size(); k += 20) readings[k] += 30;
  const auto before = readings;
  const WildReadings wild = replace_wild_readings(readings);
  EXPECT_FALSE(wild.replaced);
  EXPECT_EQ(wild.places.size(), 50u);
  EXPECT_EQ(readings, before);
}

TEST(WildReadings, GapsArePassedOver) {
  auto readings = motion(400, 40, 1e-3);
  readings[50] = NAN;
  readings[200] = 90;
  EXPECT_EQ(replace_wild_readings(readings).places, Places{200});
  EXPECT_TRUE(std::isnan(readings[50]));
}

}  // namespace
}  // namespace rubsweep::recording
