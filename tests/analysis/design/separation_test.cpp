#include "rubsweep/analysis/design/separation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/design/amplification.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {
namespace {

std::vector<Resonance> of_a_disc(double ratio, double from, double to) {
  return resonances(batch::evenly_spaced(from, to, 201),
                    [&](double speed) { return amplification(speed, ratio); });
}

/// Let s be the square of natural frequency / speed. The inverse square of the response is (s - 1)^2 + 4
/// ratio^2 s; it is twice its least value at s = 1 - 2 ratio^2 +- 2 ratio sqrt(1 - ratio^2).
TEST(SeparationResonances, HalfPowerOfADiscIsThatOfItsClosedForm) {
  for (const double ratio : {0.005, 0.02, 0.1}) {
    const double middle = 1 - 2 * ratio * ratio, half = 2 * ratio * std::sqrt(1 - ratio * ratio);
    const double top = 1 / std::sqrt(middle),
                 width = 1 / std::sqrt(middle - half) - 1 / std::sqrt(middle + half);
    const std::vector<Resonance> found = of_a_disc(ratio, 0.2, 4);
    ASSERT_EQ(found.size(), 1u) << ratio;
    EXPECT_NEAR(found[0].speed_hz, top, 1e-8);
    ASSERT_TRUE(found[0].amplification);
    EXPECT_NEAR(*found[0].amplification, top / width, 1e-6 * top / width) << ratio;
  }
}

TEST(SeparationResonances, APeakThatFallsOnOneSideAloneCountsByThatSide) {
  const double ratio = 0.4;
  const double middle = 1 - 2 * ratio * ratio, half = 2 * ratio * std::sqrt(1 - ratio * ratio);
  const double top = 1 / std::sqrt(middle), low = 1 / std::sqrt(middle + half);
  ASSERT_LT(middle - half, 0) << "far above, the response is more than its half power";
  const std::vector<Resonance> found = of_a_disc(ratio, 0.2, 4);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].amplification.value(), top / (2 * (top - low)), 1e-6);
  const std::vector<Resonance> flat = of_a_disc(ratio, 1, 4);
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_FALSE(flat[0].amplification);
  EXPECT_NEAR(flat[0].amplification_below, top / 3, 1e-6);
}

/// In a rising response, samples that differ only by rounding are not a peak.
TEST(SeparationResonances, SpeedsThatAreNearlyTheSameMakeNoPeak) {
  std::vector<double> speeds;
  for (const double speed : {0.2, 0.31, 0.47, 0.63, 0.8})
    for (int k = 0; k < 4; ++k) speeds.push_back(speed * (1 + k * 3e-16));
  EXPECT_TRUE(resonances(speeds, [](double speed) {
                return amplification(speed, 0.02) * (1 + 1e-15 * std::sin(1e17 * speed));
              }).empty());
}

TEST(SeparationResonances, AResponseWithoutPeaksHasNone) { EXPECT_TRUE(of_a_disc(0.02, 1.2, 4).empty()); }

TEST(Separation, RequiredMarginsAreThoseOfTheirFormulas) {
  EXPECT_EQ(required_separation(2.49, false), 0);
  EXPECT_EQ(required_separation(2.49, true), 0);
  EXPECT_NEAR(required_separation(3.5, false), 0.085, 1e-15);
  EXPECT_NEAR(required_separation(3.5, true), 0.185, 1e-15);
  EXPECT_EQ(required_separation(1e9, false), 0.16);
  EXPECT_EQ(required_separation(1e9, true), 0.26);
}

TEST(Separation, CountsFromTheNearerEnd) {
  EXPECT_NEAR(separation({50, 100}, 40), 0.2, 1e-15);
  EXPECT_NEAR(separation({50, 100}, 130), 0.3, 1e-15);
  EXPECT_NEAR(separation({50, 100}, 95), -0.05, 1e-15);
}

}  // namespace
}  // namespace rubsweep::design
