#include "rubsweep/measurement/scope/verdict_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "measurement/scope/samples.hpp"

namespace rubsweep::scope {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

TEST(VerdictLines, ALineBetweenTheBinsHasItsOrderAndAmplitude) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0, 0.3);
  for (const double order : {0.437, -0.2613, 1.618}) {
    std::vector<Complex> z;
    for (int k = 0; k < 90 * samples; ++k) {
      const double angle = 2 * pi * k / samples;
      z.push_back(30.0 * std::polar(1.0, angle) + 80.0 * std::polar(1.0, order * angle + 1) +
                  Complex(noise(random), noise(random)));
    }
    const Verdict verdict = judge(z, samples, true);
    ASSERT_EQ(verdict.motion, MeasuredClass::quasi_periodic);
    ASSERT_EQ(verdict.discrete_lines.size(), 2u);
    const DiscreteLine& line = verdict.discrete_lines.front();
    EXPECT_NEAR(line.order, order, 4 * line.order_uncertainty);
    EXPECT_NEAR(line.amplitude_m, 80, 4 * line.amplitude_uncertainty_m);
    EXPECT_LT(line.amplitude_uncertainty_m, 0.1);
    // The nearest bin has a matching uncertainty.
    const auto largest = std::ranges::max_element(
        verdict.lines, {}, [](const MeasuredLine& bin) { return std::abs(bin.amplitude_m); });
    ASSERT_EQ(line_of_bin(verdict, largest->order), &line);
    const Complex truth = std::polar(80.0, 1 + order * 2 * pi * (90 - 64));
    EXPECT_LT(std::abs(largest->amplitude_m - truth), 1.01 * largest->uncertainty_m + 0.1);
    EXPECT_EQ(line_of_bin(verdict, 3), nullptr);
  }
}

TEST(VerdictLines, OrdersAreThoseOfALineThatTurnsWithTheShaft) {
  // Noise has moved the marks, so that over 60 turns the motion rotates by `late_turns` less than the marks
  // indicate. In the second motion no line is a multiple of 1X, and a line far enough from 1X is not
  // rescaled.
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 0.1);
  for (const double late_turns : {0.01, 0.1}) {
    const double pace = 1 - late_turns / 60;
    std::vector<Complex> z;
    for (int k = 0; k < 60 * samples; ++k) {
      const double angle = 2 * pi * pace * k / samples;
      z.push_back(100.0 * std::polar(1.0, angle) + 30.0 * std::polar(1.0, 0.4142 * angle + 1) +
                  Complex(noise(random), noise(random)));
    }
    const Verdict verdict = judge(z, samples, true);
    ASSERT_EQ(verdict.discrete_lines.size(), 2u);
    const bool turns = late_turns < 0.05;
    const DiscreteLine &one = verdict.discrete_lines[0], &other = verdict.discrete_lines[1];
    EXPECT_NEAR(one.order, turns ? 1 : pace, 2 * one.order_uncertainty);
    EXPECT_NEAR(other.order, 0.4142 * (turns ? 1 : pace), 2 * other.order_uncertainty);
  }
}

TEST(VerdictLines, AHighOrderHasTheErrorOfItsInterpolation) {
  std::vector<Complex> z;
  for (int k = 0; k < 40 * samples; ++k) {
    const double angle = 2 * pi * k / samples;
    z.push_back(std::polar(1.0, angle) + 0.3 * std::polar(1.0, 4 * angle));
  }
  const Verdict verdict = judge(z, samples, true, {.readings_per_turn = 20});
  for (const MeasuredLine& line : verdict.lines) {
    if (line.order != 4) continue;
    EXPECT_NEAR(line.uncertainty_m, 0.3 * 0.005 * std::pow(8 * pi / 20, 6), 1e-6);
  }
}

}  // namespace
}  // namespace rubsweep::scope
