#include "rubscope/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "measurement/scope/samples.hpp"

namespace rubsweep::apps {

using namespace scope;

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A 1/2 subharmonic recorded from a shaft angle `begin`, in turns.
std::vector<Complex> half_order(int turns, double begin, double noise_m) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, noise_m);
  std::vector<Complex> z;
  for (int k = 0; k < turns * samples; ++k) {
    const double phi = 2 * pi * (begin + static_cast<double>(k) / samples);
    z.push_back(1e-3 + 8e-5 * std::polar(1.0, phi) + Complex(5e-5, 2e-5) * std::polar(1.0, phi / 2) +
                3e-5 * std::polar(1.0, -phi / 2) + Complex(noise(random), noise(random)));
  }
  return z;
}

TEST(Comparison, AlignsThePhaseAndLeavesTheNoise) {
  for (const double begin : {0.0, 0.37, 1.61}) {
    const Comparison comparison =
        compare(judge(half_order(60, begin, 1e-6), samples, true), half_order(2, 0, 0), 2, true);
    EXPECT_NEAR(comparison.turned_by, begin, 1e-4);
    // Both components contribute one standard deviation.
    EXPECT_NEAR(comparison.misfit, std::sqrt(2), 0.5);
    EXPECT_LT(comparison.unexplained, 1e-5);
    EXPECT_LT(std::abs(comparison.simulated_m[5] + 1e-3 - half_order(1, begin, 0)[5]), 1e-7);
  }
}

TEST(Comparison, AnotherMotionDiffers) {
  std::vector<Complex> circle;
  for (int k = 0; k < samples; ++k) circle.push_back(8e-5 * std::polar(1.0, 2 * pi * k / samples));
  const Comparison comparison = compare(judge(half_order(60, 0.2, 1e-6), samples, true), circle, 1, true);
  const auto worst = std::ranges::max_element(comparison.lines, {}, &ComparedLine::difference);
  EXPECT_EQ(worst->order, 0.5);
  EXPECT_GT(comparison.misfit, 100);
  EXPECT_NEAR(comparison.unexplained, (29e-10 + 9e-10) / (64e-10 + 29e-10 + 9e-10), 0.01);
  EXPECT_NE(comparison_summary(comparison).find("+0.5X: measured"), std::string::npos);
  EXPECT_NE(
      comparison_summary(comparison, {model::LengthUnit::mil, true}).find(" mil peak to peak, simulated "),
      std::string::npos);
  EXPECT_TRUE(comparison_csv(comparison).starts_with("order,measured_m,"));
}

}  // namespace
}  // namespace rubsweep::apps
