#include "rubsweep/measurement/diagnose/other_cause.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

TEST(OtherCause, VibratesAtOnceTheSpeedAndAtOthers) {
  response::spectrum::SpectrumWorkspace workspace;
  int free_orders = 0, others = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    RandomStream random(1, k, 0);
    const MotionLines lines = vibration_of_another_cause(12, random, workspace);
    ASSERT_EQ(lines.last(), static_cast<int>(12 * most_order));
    EXPECT_GT(std::abs(lines.at(12)), 0.05);
    double between = 0;
    for (int j = -lines.last(); j <= lines.last(); ++j)
      if (j % 12 != 0) between += std::norm(lines.at(j));
    (between > 1e-4 ? free_orders : others) += 1;
  }
  // There are one to four components, half of which are multiples of the speed; otherwise only an ellipse.
  EXPECT_GT(free_orders, 80);
  EXPECT_GT(others, 40);
}

TEST(OtherCause, WhirlsForwardBelowHalfTheSpeedMoreOftenThanAtOtherOrders) {
  response::spectrum::SpectrumWorkspace workspace;
  constexpr int turns = 50;
  int oil_film = 0, other = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    RandomStream random(2, k, 0);
    const MotionLines lines = vibration_of_another_cause(turns, random, workspace);
    int largest = 1;
    for (int j = 1; j < turns; ++j)
      if (std::norm(lines.at(j)) > std::norm(lines.at(largest))) largest = j;
    const double order = static_cast<double>(largest) / turns, forward = std::norm(lines.at(largest));
    if (forward < 1e-2 || std::norm(lines.at(-largest)) > forward / 4) continue;
    (order > 0.36 && order < 0.52 ? oil_film : other) += 1;
  }
  EXPECT_GT(oil_film, 60);
  EXPECT_GT(other, 40);
  EXPECT_GT(oil_film, other);
}

TEST(OtherCause, VibratesAlongOneDirectionAtItsMultiplesNowAndThen) {
  response::spectrum::SpectrumWorkspace workspace;
  constexpr int turns = 12, all = 500;
  int along_one = 0;
  for (std::uint64_t k = 0; k < all; ++k) {
    RandomStream random(3, k, 0);
    const MotionLines lines = vibration_of_another_cause(turns, random, workspace);
    // A line across the shaft is an ellipse without area: its forward and backward amplitudes are equal.
    int without_area = 0;
    for (int order = 2; order <= 5; ++order) {
      const double forward = std::abs(lines.at(order * turns)), backward = std::abs(lines.at(-order * turns));
      without_area += forward > 1e-8 && std::abs(forward - backward) < 1e-3 * forward;
    }
    along_one += without_area == 4;
  }
  // Each of one to four components may be along a line; a free order or a multiple may overlap with it.
  EXPECT_GT(along_one, all / 10);
  EXPECT_LT(along_one, all / 3);
}

TEST(OtherCause, DependsOnItsRandomNumbersAlone) {
  response::spectrum::SpectrumWorkspace workspace;
  RandomStream one(1, 5, 0), again(1, 5, 0);
  EXPECT_EQ(vibration_of_another_cause(12, one, workspace).amplitude,
            vibration_of_another_cause(12, again, workspace).amplitude);
}

TEST(OtherCause, KeepsItsLinesAtAnotherSpeedOrLosesOrChangesThem) {
  response::spectrum::SpectrumWorkspace workspace;
  int alone = 0, same = 0, other = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    RandomStream random(3, k, 0);
    MotionLines lines = vibration_of_another_cause(12, random, workspace);
    lines.at(0) = 0.25;
    const MotionLines there = vibration_at_another_speed(lines, random, workspace);
    EXPECT_EQ(there.at(0), 0.25);
    const double ratio_1x = std::abs(there.at(12) / lines.at(12)),
                 ratio_2x = std::abs(there.at(24) / lines.at(24)),
                 ratio_3x = std::abs(there.at(36) / lines.at(36));
    if (ratio_2x == 0)
      ++alone;
    else if (std::abs(ratio_2x / ratio_3x - 1) < 1e-9)
      ++same;
    else
      ++other;
    if (ratio_2x == 0 || std::abs(ratio_2x / ratio_3x - 1) < 1e-9) {
      EXPECT_GE(ratio_1x, 0.1);
      EXPECT_LE(ratio_1x, 10);
    }
  }
  for (const int count : {alone, same, other}) EXPECT_NEAR(count, 100, 30);
}

}  // namespace
}  // namespace rubsweep::diagnose
