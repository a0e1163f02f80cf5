#include "rubsweep/measurement/recording/found_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::recording {
namespace {

using std::numbers::pi;

/// Readings of two probes with a gap voltage: 1X of 60, 2X of 10, and a line of another order.
std::vector<std::vector<double>> readings(double speed_hz, double rate_hz, double turns, double other_order,
                                          double other, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise);
  std::vector<std::vector<double>> probes(2);
  for (int k = 0; k < turns / speed_hz * rate_hz; ++k) {
    const double angle = 2 * pi * speed_hz * k / rate_hz;
    for (std::size_t i = 0; i < 2; ++i) {
      const double quarter = i == 0 ? 0 : pi / 2;
      probes[i].push_back(900 + 60 * std::cos(angle - quarter) + 10 * std::cos(2 * angle + 1) +
                          other * std::cos(other_order * angle + quarter) + normal(random));
    }
  }
  return probes;
}

TEST(FoundSpeed, TwoHarmonicsSayItWhereTheLineItselfIsMissing) {
  for (const bool third : {true, false}) {
    std::vector<double> x;
    for (int k = 0; k < 4000; ++k) {
      const double angle = 2 * pi * 30.06 * k / 2000;
      x.push_back(5 * std::cos(2 * angle + 1) + (third ? 3 * std::cos(3 * angle) : 0.0));
    }
    const auto found = speed_near({x}, 2000, 30);
    if (third) {
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->speed_hz, 30.06, 1e-4);
      EXPECT_TRUE(found->by_harmonics);
    } else {  // a single line may come from another machine
      EXPECT_TRUE(!found || found->speed_hz == 0);
    }
  }
}

TEST(FoundSpeed, IsTheTruthWithinItsUncertainty) {
  double squares = 0;
  int count = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double speed_hz = 20 + 60 * uniform(random),
                 given_hz = speed_hz * (1 + 0.03 * (uniform(random) - 0.5));
    const double rate_hz = speed_hz * (8 + 60 * uniform(random)), turns = 25 + 60 * uniform(random);
    const auto found = speed_near(readings(speed_hz, rate_hz, turns, 0.42, 20 * uniform(random), 2, seed),
                                  rate_hz, given_hz);
    ASSERT_TRUE(found) << seed;
    ASSERT_GT(found->speed_hz, 0) << seed;
    squares += std::pow((found->speed_hz - speed_hz) / found->uncertainty_hz, 2);
    ++count;
    EXPECT_LT(std::abs(found->speed_hz - speed_hz) / speed_hz * turns, 5e-3) << seed;
  }
  EXPECT_LT(squares / count, 3);
}

TEST(FoundSpeed, IsTakenWhereItMoves) {
  std::vector<std::string> findings;
  EXPECT_EQ(speed_to_take(30, std::nullopt, 60, findings), 30);
  EXPECT_EQ(speed_to_take(30, FoundSpeed{29.9999, 1e-6, 29.9999}, 60, findings), 30);
  EXPECT_EQ(speed_to_take(30, FoundSpeed{29.99, 0.01, 29.99}, 60, findings), 30);
  EXPECT_TRUE(findings.empty());
  EXPECT_EQ(speed_to_take(30, FoundSpeed{29.99, 1e-4, 29.99}, 60, findings), 29.99);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0],
            "the speed is taken from the signal: 29.99 Hz (1799.4 rpm) +- 0.0001 Hz, where speed_hz says 30 "
            "Hz (1800 rpm)");
}

TEST(FoundSpeed, ALineThatIsFartherOffIsSaid) {
  const auto found = speed_near(readings(50, 2000, 60, 0.42, 5, 1, 1), 2000, 47.3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->speed_hz, 0);
  std::vector<std::string> findings;
  EXPECT_EQ(speed_to_take(47.3, found, 60, findings), 47.3);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(findings[0].starts_with("speed_hz is 47.3 Hz (2838 rpm), and no line stands within 2 % of it;"))
      << findings[0];
}

TEST(FoundSpeed, NoiseHasNone) {
  const auto noise = readings(50, 2000, 60, 0.42, 0, 2000, 1);
  EXPECT_FALSE(speed_near(noise, 2000, 50));
}

}  // namespace
}  // namespace rubsweep::recording
