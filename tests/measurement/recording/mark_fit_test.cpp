#include "rubsweep/measurement/recording/mark_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measurement/recording/shaft_marks.hpp"

namespace rubsweep::recording {
namespace {

using std::numbers::pi;

/// The sample after each instant, less half a step: what an edge shorter than a step becomes.
std::vector<double> rounded(const std::vector<double>& marks, double step_s) {
  std::vector<double> rounded;
  for (const double t_s : marks) rounded.push_back((std::ceil(t_s / step_s) - 0.5) * step_s);
  return rounded;
}

TEST(MarkFit, RoundedMarksComeBackToTheirPlaces) {
  const double step_s = 2e-4;
  for (const double rate : {0.0, 0.5, -0.4}) {
    const auto truth = turns_s(400, 70.1, rate);
    const auto marks = rounded(truth, step_s);
    EXPECT_GT(largest_error(marks, truth), 0.45 * step_s);
    EXPECT_LT(largest_error(smoothed_marks(marks, step_s).t_s, truth), 0.05 * step_s) << rate;
  }
}

TEST(MarkFit, FewMarksComeBackToAShareOfASample) {
  // 32 turns of 20 to 200 samples.
  const double step_s = 2e-4;
  std::vector<double> errors;
  for (int i = 0; i < 200; ++i) {
    const double samples = 20 * std::pow(10, i / 199.0);
    for (const double change : {0.0, 3e-3}) {
      const double f = 1 / (samples * step_s), turns = 32;
      const auto truth = turns_s(static_cast<int>(turns) + 1, f, change * f * f / turns);
      errors.push_back(largest_error(smoothed_marks(rounded(truth, step_s), step_s).t_s, truth) / step_s);
    }
  }
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 0.12);
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.45);
  // Half a sample from mark to curve, and half of one from mark to truth.
  EXPECT_LT(errors.back(), 0.5 + smoothing_bound);
}

TEST(MarkFit, ASpeedThatSwaysKeepsItsSway) {
  // Eight steps to and fro every 100 turns.
  const double step_s = 2e-4;
  auto truth = turns_s(800, 70.1, 0);
  for (std::size_t k = 0; k < truth.size(); ++k)
    truth[k] += 8 * step_s * std::sin(2 * pi * static_cast<double>(k) / 100);
  EXPECT_LT(largest_error(smoothed_marks(rounded(truth, step_s), step_s).t_s, truth), 0.6 * step_s);
}

TEST(MarkFit, MarksThatNoSmoothCurveExplainsStay) {
  auto marks = turns_s(200, 50, 0);
  for (std::size_t k = 0; k < marks.size(); k += 2) marks[k] += 1e-3;
  EXPECT_EQ(smoothed_marks(marks, 1e-4).t_s, marks);
  EXPECT_EQ(smoothed_marks(marks, 0).t_s, marks);
}

TEST(MarkFit, ResolutionIsThatOfTheEdges) {
  const auto pulses = [](double edge) {
    std::vector<double> signal;
    for (int k = 0; k < 5000; ++k) {
      const double since = std::fmod(k, 71.3);
      signal.push_back(since < 8 ? std::fmin(1, since / edge) : 0);
    }
    return signal;
  };
  EXPECT_EQ(mark_resolution(pulses(0.01), Mark::bright, 0.5), 1);
  EXPECT_EQ(mark_resolution(pulses(4), Mark::bright, 0.5), 0);
  const double between = mark_resolution(pulses(1.3), Mark::bright, 0.5);
  EXPECT_GT(between, 0);
  EXPECT_LT(between, 1);
  // The trailing edge is sharp whatever the leading one is.
  EXPECT_EQ(mark_resolution(pulses(4), Mark::dark, 0.5), 1);
}

}  // namespace
}  // namespace rubsweep::recording
