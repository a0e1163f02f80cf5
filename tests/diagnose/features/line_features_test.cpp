#include "rubsweep/diagnose/features/line_features.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "turned_lines.hpp"
#include "value_of.hpp"

namespace rubsweep::diagnose::features {
namespace {

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
  // A line at 0.43X over 30 turns, as a transform of its samples has it.
  constexpr int turns = 30, n = 32;
  std::vector<std::complex<double>> samples;
  for (int j = 0; j < turns * n; ++j) {
    const double angle = 2 * 3.14159265358979324 * j / n;
    samples.push_back(std::polar(1.0, angle) + std::polar(0.5, 0.43 * angle));
  }
  response::spectrum::SpectrumWorkspace workspace;
  const Features features = line_features(lines_of(samples, turns, 4, workspace), true);
  EXPECT_NEAR(value_of(features, "order of line 1 between multiples"), 0.43, 0.005);
  EXPECT_NEAR(std::pow(10, value_of(features, "energy of line 1 between multiples")), 0.2, 0.02);
}

TEST(LineFeatures, OfACircleHaveNothingBetweenMultiples) {
  MotionLines lines{12, Eigen::VectorXcd::Zero(2 * 72 + 1)};
  lines.at(12) = 1;
  const Features features = line_features(lines, true);
  EXPECT_NEAR(value_of(features, "energy at 1X"), 0, 1e-9);
  EXPECT_EQ(value_of(features, "energy between multiples"), -7);
  EXPECT_EQ(value_of(features, "order of line 1 between multiples"), 0);
}

}  // namespace
}  // namespace rubsweep::diagnose::features
