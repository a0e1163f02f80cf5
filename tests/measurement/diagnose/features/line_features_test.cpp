#include "rubsweep/measurement/diagnose/features/line_features.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "tones.hpp"
#include "turned_lines.hpp"
#include "value_of.hpp"

namespace rubsweep::diagnose::features {
namespace {

TEST(LineFeaturesFeature, IsAddedInOrder) {
  Features features;
  add(features, "one", 1);
  add(features, "two", 2);
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[1].name, "two");
  EXPECT_EQ(features[1].value, 2);
}

TEST(LineFeatures, AreSharesOfTheEnergy) {
  const MotionLines lines = crooked_motion();
  const double all = size_of(lines) * size_of(lines);
  const Features features = line_features(lines, true);
  EXPECT_NEAR(value_of(features, "energy at 1X"), std::log10(std::norm(lines.at(12)) / all), 1e-9);
  EXPECT_NEAR(value_of(features, "energy at -2X"), std::log10(std::norm(lines.at(-24)) / all), 1e-9);
  const double halves = std::norm(lines.at(6)) + std::norm(lines.at(-6)) + std::norm(lines.at(18));
  EXPECT_NEAR(value_of(features, "energy between multiples"), std::log10(halves / all), 1e-9);
  EXPECT_NEAR(value_of(features, "backward energy between multiples"),
              std::log10(std::norm(lines.at(-6)) / all), 1e-9);
  EXPECT_NEAR(value_of(features, "order of line 1 between multiples"), 0.5, 1e-9);
}

TEST(LineFeatures, FindALineBetweenTwoBins) {
  const Features features = line_features(tones({{1, 1}, {0.43, 0.5}}), true);
  EXPECT_NEAR(value_of(features, "order of line 1 between multiples"), 0.43, 0.005);
  EXPECT_NEAR(std::pow(10, value_of(features, "energy of line 1 between multiples")), 0.2, 0.02);
}

TEST(LineFeatures, TellATorusFromTwoCauses) {
  const std::vector<Tone> torus{{1, 1}, {0.43, 0.5}, {1.43, 0.2}, {0.57, 0.2}, {-0.43, 0.1}};
  std::vector<Tone> causes = torus;
  causes.push_back({0.22, 0.5});
  const char* off = "energy off the sidebands of line 1 between multiples";
  EXPECT_LT(value_of(line_features(tones(torus), true), off), -2);
  const double share = 0.25 / (0.25 + 0.25 + 0.04 + 0.04 + 0.01);
  EXPECT_NEAR(value_of(line_features(tones(causes), true), off), std::log10(share), 0.1);
}

TEST(LineFeatures, TellAnAddedVibrationFromOneThatAContactMixes) {
  const char* off = "energy off the order of line 1 between multiples";
  EXPECT_LT(value_of(line_features(tones({{1, 1}, {0.43, 0.5}, {-0.43, 0.1}}), true), off), -4);
  const std::vector<Tone> mixed{{1, 1}, {0.43, 0.5}, {1.43, 0.2}, {2.43, 0.2}};
  EXPECT_NEAR(value_of(line_features(tones(mixed), true), off), std::log10(0.08 / 0.33), 0.02);
}

TEST(LineFeatures, TellAStraightMotionFromACircle) {
  // A circle at 1X beside vibrations along 0.3 rad, with other phases: z = e^(0.3 i) cos(k phi + phase).
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 72 + 1)};
  lines.at(12) = 1;
  for (const auto& [k, phase] : {std::pair{6, 0.2}, {24, 1.4}, {30, 2.5}}) {
    lines.at(k) = std::polar(0.2, 0.3 + phase);
    lines.at(-k) = std::polar(0.2, 0.3 - phase);
  }
  const Features straight = line_features(lines, true);
  for (const char* part :
       {"motion off 1X", "acceleration off 1X", "motion at multiples", "acceleration between multiples"})
    EXPECT_EQ(value_of(straight, std::string("straightness of ") + part), 3) << part;
  // A backward line alone is a circle: with energies 0.08 and 0.08 the straightness falls to 1/2.
  for (const int k : {6, 30}) lines.at(k) = lines.at(-k) = 0;
  lines.at(-36) = std::sqrt(0.08);
  EXPECT_NEAR(value_of(line_features(lines, true), "straightness of motion at multiples"), std::log10(2),
              1e-9);
  EXPECT_EQ(value_of(line_features(lines, true), "straightness of motion between multiples"), 0);
}

TEST(LineFeatures, TellALineFromABandOfLines) {
  std::vector<Tone> band{{1, 1}, {0.43, 0.5}};
  const double narrow = value_of(line_features(tones(band), true), "width of line 1 between multiples");
  for (const double beside : {-0.15, -0.1, 0.1, 0.15}) band.push_back({0.43 + beside, 0.35});
  EXPECT_LT(narrow, -1);
  EXPECT_GT(value_of(line_features(tones(band), true), "width of line 1 between multiples"), -0.4);
}

TEST(LineFeatures, TellOddMultiplesFromEvenOnes) {
  const char* parity = "even over odd multiples";
  EXPECT_LT(value_of(line_features(tones({{1, 1}, {3, 0.2}, {-5, 0.1}}), true), parity), -5);
  EXPECT_GT(value_of(line_features(tones({{1, 1}, {2, 0.2}, {-4, 0.1}}), true), parity), 5);
  EXPECT_NEAR(value_of(line_features(tones({{1, 1}, {2, 0.2}, {3, 0.2}}), true), parity), 0, 1e-6);
}

TEST(LineFeatures, OfACircleHaveNothingBetweenMultiples) {
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 72 + 1)};
  lines.at(12) = 1;
  const Features features = line_features(lines, true);
  EXPECT_NEAR(value_of(features, "energy at 1X"), 0, 1e-9);
  EXPECT_EQ(value_of(features, "energy between multiples"), -7);
  EXPECT_EQ(value_of(features, "order of line 1 between multiples"), 0);
}

TEST(LineFeatures, KeepsALineBetweenTwoBinsTogether) {
  const HannEnergy energy(tones({{1, 1}, {0.43, 0.5}}), true);
  EXPECT_NEAR(energy.near(1, 2), 0.8, 0.005);
  EXPECT_NEAR(energy.near(0.43, 2), 0.2, 0.005);
  EXPECT_NEAR(energy.near(-0.43, 2), 0, 1e-6);
}

TEST(LineFeatures, OfOneProbeCountsOrdersFrom0On) {
  const HannEnergy energy(one_reading(tones({{1, 1}, {0.43, 0.5}})), false);
  EXPECT_EQ(energy.first(), 1);
  EXPECT_EQ(energy[-30], 0);
  EXPECT_NEAR(energy.near(1, 2), 0.8, 0.005);
}

TEST(LineFeatures, FindsTheStrongestLinesAwayFromTheMultiples) {
  MotionLines lines = tones({{1, 1}, {0.43, 0.5}});
  lines.at(50) = 0.1;
  const HannEnergy energy(lines, true);
  const int first = strongest_between_multiples(energy, {});
  EXPECT_NEAR(order_of_line(energy, first), 0.43, 0.002);
  EXPECT_EQ(strongest_between_multiples(energy, {first}), 50);
}

TEST(LineFeatures, OfACircleHasNoLineBetweenTheMultiples) {
  MotionLines lines{30, Eigen::VectorXcd::Zero(2 * 240 + 1)};
  lines.at(30) = 1;
  const HannEnergy energy(lines, true);
  EXPECT_EQ(strongest_between_multiples(energy, {}), 0);
}

TEST(LineFeatures, TellsWhatIsBetweenMultiples) {
  const HannEnergy energy(tones({{1, 1}, {0.43, 0.5}}), true);
  for (const int k : {-30, 0, 2, 28, 62}) EXPECT_FALSE(between_multiples(energy, k, 2)) << k;
  for (const int k : {-33, 3, 15, 27, 63}) EXPECT_TRUE(between_multiples(energy, k, 2)) << k;
}

}  // namespace
}  // namespace rubsweep::diagnose::features
