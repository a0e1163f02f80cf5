#include "rubsweep/measurement/recording/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::recording {
namespace {

std::vector<std::string> of_readings(const std::vector<double>& readings,
                                     std::optional<double> full_scale = {}) {
  const Channels table{.channels = {{"x", "", readings}}};
  std::vector<std::string> findings;
  add_findings(table.channels.front(), table, full_scale, findings);
  return findings;
}

TEST(Findings, ClippedIsNotTheFlatTopOfACoarseConverter) {
  std::vector<double> coarse, clipped, both;
  for (int k = 0; k < 4000; ++k) {
    const double value = std::sin(0.005 * k);
    coarse.push_back(std::round(200 * value) / 200);
    clipped.push_back(std::fmin(value, 0.5));
    both.push_back(std::fmin(std::fmax(std::round(200 * std::sin(0.3 * k)) / 200, -0.1), 0.1));
  }
  EXPECT_TRUE(of_readings(coarse).empty());
  EXPECT_EQ(of_readings(clipped), std::vector<std::string>{"'x' is clipped above"});
  EXPECT_EQ(of_readings(both), std::vector<std::string>{"'x' is clipped at both ends of its range"});
}

TEST(Findings, ReadingsAtFullScaleAreClippedHoweverShort) {
  EXPECT_TRUE(of_readings({0, 9.5, 3, -9}, 10).empty());
  EXPECT_EQ(of_readings({0, 9.5, 3, -10}, 10), std::vector<std::string>{"'x' is clipped below"});
}

TEST(Findings, AliasingOfVibrationBesideHalfTheSamplingRate) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<double> clean, noisy, folded;
  for (int k = 0; k < 3000; ++k) {
    clean.push_back(std::sin(0.3 * k) + 0.2 * std::sin(0.9 * k + 1));
    noisy.push_back(clean.back() + noise(random));
    folded.push_back(noisy.back() + 0.1 * std::cos(0.96 * std::numbers::pi * k));
  }
  EXPECT_TRUE(of_readings(clean).empty());
  EXPECT_TRUE(of_readings(noisy).empty());
  ASSERT_EQ(of_readings(folded).size(), 1u);
  EXPECT_TRUE(of_readings(folded).front().starts_with("'x' vibrates just below half the sampling rate"));
}

TEST(Findings, FewReadingsATurnAreClippedToo) {
  std::vector<double> clipped;
  for (int k = 0; k < 1000; ++k)
    clipped.push_back(std::fmin(40 * std::cos(0.05 * std::numbers::pi * k) + 0.01 * std::sin(4 * k), 25));
  EXPECT_EQ(of_readings(clipped), std::vector<std::string>{"'x' is clipped above"});
}

TEST(Findings, FewReadingsATurnAreClippedWhereTheyPileUp) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.005);
  std::vector<double> analog, clipped, converted, coarse;
  for (int k = 0; k < 1500; ++k) {
    analog.push_back(std::sin(0.47 * k) + 0.2 * std::sin(0.235 * k) + noise(random));
    clipped.push_back(std::fmin(analog.back(), 0.9));
    converted.push_back(std::round(500 * clipped.back()) / 500);
    coarse.push_back(std::round(20 * analog.back()) / 20);
  }
  EXPECT_TRUE(of_readings(analog).empty());
  EXPECT_TRUE(of_readings(coarse).empty());
  EXPECT_EQ(of_readings(clipped), std::vector<std::string>{"'x' is clipped above"});
  EXPECT_EQ(of_readings(converted), std::vector<std::string>{"'x' is clipped above"});
}

TEST(Findings, AMotionWithoutNoiseThatRepeatsIsNotClipped) {
  std::vector<double> periodic, square;
  for (int k = 0; k < 1400; ++k) {
    periodic.push_back(std::cos(2 * std::numbers::pi * (k % 14 + 0.5) / 14));
    square.push_back(k % 14 < 4 ? 1 : k % 14 < 8 ? 0 : -1);
  }
  EXPECT_TRUE(of_readings(periodic).empty());
  EXPECT_TRUE(of_readings(square).empty());
}

TEST(Findings, MarksOfAKeyphasor) {
  std::vector<std::string> findings;
  add_mark_findings({}, {.column = "KP"}, findings);
  EXPECT_TRUE(findings.empty());
  add_mark_findings({.t_s = {}, .filled = 2, .dropped = 1}, {.column = "KP"}, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_TRUE(findings[0].starts_with("'KP' has no mark in 2 turns"));
  EXPECT_TRUE(findings[1].starts_with("'KP' has 1 marks too many"));
}

TEST(Findings, MissingPulsesSayHowWellTheyFollowFromTheOthers) {
  std::vector<double> marks;
  for (int k = 0; k < 40; ++k) marks.push_back(k + (k == 20 ? 0.1 : 0.0));
  std::vector<std::string> findings;
  add_mark_findings({.t_s = marks, .filled = 3}, {.column = "KP", .pulses_per_turn = 12}, findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(
      findings[0],
      "'KP' has no mark in 3 steps: they are taken to be like those beside them, whose marks follow from "
      "their neighbours to 0.023 of a step");
  EXPECT_NE(findings[1].find("12 pulses a turn"), std::string::npos);
}

TEST(Findings, AnUnsteadySpeedAndFewReadings) {
  std::vector<std::string> findings;
  add_speed_findings(std::vector<double>{0, 0.1, 0.2, 0.3}, 1000, findings);
  EXPECT_TRUE(findings.empty());
  add_speed_findings(std::vector<double>{0, 0.1, 0.2, 0.325}, 1000, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0],
            "the speed is unsteady: at 0.2 s it goes from 10 to 8 Hz (600 to 480 rpm) within a turn");
  findings.clear();
  add_speed_findings(std::vector<double>{0, 0.1, 0.2}, 150, findings);
  EXPECT_EQ(findings,
            std::vector<std::string>{"15 readings a turn: motion above 7.5X is folded to other orders"});
}

}  // namespace
}  // namespace rubsweep::recording
