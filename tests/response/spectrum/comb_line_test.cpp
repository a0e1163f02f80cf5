#include "rubsweep/response/spectrum/comb_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "response/spectrum/comb_samples.hpp"
#include "response/synthetic_motion.hpp"

namespace rubsweep::response::testing {
namespace {

std::optional<spectrum::SpectralLine> largest_of(const std::function<Complex(double)>& z, double spacing) {
  return spectrum::largest_comb_line(sample(z, 0, comb_turns, comb_samples_per_turn), comb_samples_per_turn,
                                     spacing);
}

TEST(CombLineLargest, HasTheOrderAndAmplitudeThatStandBetweenTwoBins) {
  // 1 - 2 * 0.8431: half a bin from the nearest, where a plain spectrum shows 64 %.
  for (const double spacing : {0.8431, 1.8357, 2.6857}) {
    const auto line = largest_of(
        [=](double turn) { return 0.2 * phasor(1, turn) + 0.9 * phasor(1 - 2 * spacing, turn); }, spacing);
    ASSERT_TRUE(line);
    EXPECT_DOUBLE_EQ(line->order, 1 - 2 * spacing);
    EXPECT_NEAR(line->amplitude_m, 0.9, 1e-6);
  }
}

TEST(CombLineLargest, IsTheLargerOfTwoThatBinsWouldSwap) {
  // In bins of 1/128 the first stands on one, the second half a bin off: 0.9 against 0.64.
  const double spacing = 0.5 + 1.0 / 512;
  const auto line = largest_of(
      [=](double turn) { return 0.9 * phasor(1, turn) + 1.0 * phasor(1 + 2 * spacing, turn); }, spacing);
  ASSERT_TRUE(line);
  EXPECT_DOUBLE_EQ(line->order, 1 + 2 * spacing);
  EXPECT_NEAR(line->amplitude_m, 1, 1e-6);
}

TEST(CombLineLargest, IsNeverTheMean) {
  const auto line = largest_of([](double turn) { return 2.0 + 0.3 * phasor(1.5, turn); }, 0.5);
  ASSERT_TRUE(line);
  EXPECT_DOUBLE_EQ(line->order, 1.5);
  EXPECT_NEAR(line->amplitude_m, 0.3, 1e-4);
}

TEST(CombLineLargest, OfRestIsNone) {
  EXPECT_FALSE(largest_of([](double) { return Complex(0); }, 0.5));
}

}  // namespace
}  // namespace rubsweep::response::testing
