#include "rubsweep/measurement/diagnose/observed_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace rubsweep::diagnose {
namespace {

MotionLines circle() {
  MotionLines lines{20, Eigen::VectorXcd::Zero(2 * 160 + 1)};
  lines.at(20) = 1;
  return lines;
}

/// Probes that add next to nothing of their own.
Measuring undisturbed(int probes) {
  return {.probes = probes,
          .readings_per_turn = 1e12,
          .noise_share = {1e-9, 1e-9, true},
          .other_lines = {0, 0, 0},
          .gain_error = 0};
}

TEST(ObservedLines, HaveTheNoiseOfTheReadings) {
  const Measuring measuring{.probes = 2,
                            .readings_per_turn = 50,
                            .noise_share = {0.1, 0.1, true},
                            .other_lines = {0, 0, 0},
                            .gain_error = 0};
  double sum = 0, probe_angle_rad = 1;
  long count = 0;
  for (std::uint64_t k = 0; k < 50; ++k) {
    RandomStream random(1, k, 2);
    const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
    for (int j = -seen.last(); j <= seen.last(); ++j)
      if (j != 20) {
        sum += std::norm(seen.at(j));
        ++count;
      }
  }
  EXPECT_EQ(probe_angle_rad, 0);
  // Each line keeps 2 x 0.01 / 1000 of 1000 complex readings with 0.1 in x and in y.
  EXPECT_NEAR(sum / static_cast<double>(count), 2e-5, 0.02 * 2e-5);
}

TEST(ObservedLines, OfOneProbeAreThoseOfARealSignal) {
  const Measuring measuring{.probes = 1, .readings_per_turn = 50};
  RandomStream random(3, 1, 2);
  double probe_angle_rad = 0;
  const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
  EXPECT_NE(probe_angle_rad, 0);
  for (int k = 0; k <= seen.last(); ++k) EXPECT_LT(std::abs(seen.at(-k) - std::conj(seen.at(k))), 1e-15);
  EXPECT_NEAR(std::abs(seen.at(20)), 0.5, 0.2);
}

TEST(ObservedLines, OfOneProbeWhoseDirectionIsKnownAreThoseInIt) {
  Measuring measuring = undisturbed(1);
  measuring.directions = true;
  measuring.probe_angle_rad = 0.7;
  RandomStream random(3, 1, 2);
  double probe_angle_rad = 0;
  const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
  EXPECT_EQ(probe_angle_rad, 0.7);
  EXPECT_LT(std::abs(seen.at(20) - std::polar(0.5, -0.7)), 1e-6);
}

TEST(ObservedLines, CountFromAPlaceOfRestThatIsKnownNearly) {
  Measuring measuring{.readings_per_turn = 50, .from_rest = true};
  double square = 0, probe_angle_rad = 0;
  constexpr int draws = 400;
  for (std::uint64_t k = 0; k < draws; ++k) {
    RandomStream random(4, k, 2);
    square += std::norm(observed(circle(), measuring, random, probe_angle_rad).at(0)) / draws;
  }
  // In x and in y, and the noise of a line beside it.
  EXPECT_NEAR(square, 2 * Measuring::rest_error * Measuring::rest_error, 1e-4);
}

TEST(ObservedLines, OfUnequalGainsAreAnEllipse) {
  Measuring measuring = undisturbed(2);
  measuring.gain_error = 0.1;
  RandomStream random(5, 1, 2);
  double probe_angle_rad = 0;
  const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
  // Gains gx and gy: (gx + gy) / 2 forward, (gx - gy) / 2 backward.
  const double gx = (seen.at(20) + seen.at(-20)).real(), gy = (seen.at(20) - seen.at(-20)).real();
  EXPECT_NE(gx, gy);
  EXPECT_NEAR(gx, 1, 0.5);
  EXPECT_NEAR(gy, 1, 0.5);
}

}  // namespace
}  // namespace rubsweep::diagnose
