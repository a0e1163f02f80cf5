#include "rubsweep/diagnose/features/hann_energy.hpp"

#include <gtest/gtest.h>

#include "tones.hpp"
#include "turned_lines.hpp"

namespace rubsweep::diagnose::features {
namespace {

TEST(HannEnergy, KeepsALineBetweenTwoBinsTogether) {
  const HannEnergy energy(tones({{1, 1}, {0.43, 0.5}}), true);
  EXPECT_NEAR(energy.near(1, 2), 0.8, 0.005);
  EXPECT_NEAR(energy.near(0.43, 2), 0.2, 0.005);
  EXPECT_NEAR(energy.near(-0.43, 2), 0, 1e-6);
}

TEST(HannEnergy, OfOneProbeCountsOrdersFrom0On) {
  const HannEnergy energy(one_reading(tones({{1, 1}, {0.43, 0.5}})), false);
  EXPECT_EQ(energy.first(), 1);
  EXPECT_EQ(energy[-30], 0);
  EXPECT_NEAR(energy.near(1, 2), 0.8, 0.005);
}

TEST(HannEnergy, FindsTheStrongestLinesAwayFromTheMultiples) {
  MotionLines lines = tones({{1, 1}, {0.43, 0.5}});
  lines.at(50) = 0.1;
  const HannEnergy energy(lines, true);
  const int first = strongest_between_multiples(energy, {});
  EXPECT_NEAR(order_of_line(energy, first), 0.43, 0.002);
  EXPECT_EQ(strongest_between_multiples(energy, {first}), 50);
}

TEST(HannEnergy, OfACircleHasNoLineBetweenTheMultiples) {
  MotionLines lines{30, Eigen::VectorXcd::Zero(2 * 240 + 1)};
  lines.at(30) = 1;
  const HannEnergy energy(lines, true);
  EXPECT_EQ(strongest_between_multiples(energy, {}), 0);
}

TEST(HannEnergy, TellsWhatIsBetweenMultiples) {
  const HannEnergy energy(tones({{1, 1}, {0.43, 0.5}}), true);
  for (const int k : {-30, 0, 2, 28, 62}) EXPECT_FALSE(between_multiples(energy, k, 2)) << k;
  for (const int k : {-33, 3, 15, 27, 63}) EXPECT_TRUE(between_multiples(energy, k, 2)) << k;
}

}  // namespace
}  // namespace rubsweep::diagnose::features
