#include "rubsweep/measurement/recording/turns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::recording {
namespace {

using std::numbers::pi;

TEST(Turns, SteadyOnes) {
  EXPECT_EQ(steady_turns_s(1, 2.1, 4), (std::vector<double>{1, 1.25, 1.5, 1.75, 2}));
  EXPECT_EQ(turn_speeds_hz(steady_turns_s(1, 2.1, 4)), (std::vector<double>{4, 4, 4, 4}));
}

/// Marks where f t + r t^2 / 2 is whole.
TEST(Turns, EqualAnglesOfASpeedThatChangesEvenly) {
  const double f = 50, rate = 3, sampling = 5000, first = 0.25;
  std::vector<double> signal, marks;
  for (int k = 0; k < 10000; ++k) {
    const double t = k / sampling;
    signal.push_back(std::cos(2 * pi * 3 * (f * t + rate * t * t / 2)));
  }
  for (int n = 1; n <= 90; ++n) marks.push_back(first + (std::sqrt(f * f + 2 * rate * n) - f) / rate);
  const auto samples = at_equal_angles(signal, first, sampling, marks, 64);
  ASSERT_EQ(samples.size(), 89u * 64u);
  for (std::size_t k = 0; k < samples.size(); ++k)
    EXPECT_NEAR(samples[k], std::cos(2 * pi * 3 * static_cast<double>(k) / 64), 1e-6) << k;
}

TEST(Turns, AGapStaysOne) {
  std::vector<double> signal(1000, 1.0);
  signal[500] = NAN;
  const auto samples = at_equal_angles(signal, 0, 1000, steady_turns_s(0, 0.999, 10), 16);
  EXPECT_TRUE(std::isnan(samples[5 * 16]));
  EXPECT_NEAR(samples[3 * 16], 1, 1e-12);
}

}  // namespace
}  // namespace rubsweep::recording
