#include "rubsweep/measurement/recording/shaft_turns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measurement/recording/shaft_marks.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {
namespace {

using std::numbers::pi;

TEST(ShaftTurnsTurns, SteadyOnes) {
  EXPECT_EQ(steady_turns_s(1, 2.1, 4), (std::vector<double>{1, 1.25, 1.5, 1.75, 2}));
  EXPECT_EQ(turn_speeds_hz(steady_turns_s(1, 2.1, 4)), (std::vector<double>{4, 4, 4, 4}));
}

/// Marks are at whole values of f t + r t^2 / 2.
TEST(ShaftTurnsTurns, EqualAnglesOfASpeedThatChangesEvenly) {
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

TEST(ShaftTurnsTurns, AGapStaysOne) {
  std::vector<double> signal(1000, 1.0);
  signal[500] = NAN;
  const auto samples = at_equal_angles(signal, 0, 1000, steady_turns_s(0, 0.999, 10), 16);
  EXPECT_TRUE(std::isnan(samples[5 * 16]));
  EXPECT_NEAR(samples[3 * 16], 1, 1e-12);
}

constexpr double rate_hz = 5000, speed_hz = 121.3;

/// Channels with a sharp-edged keyway over 40 turns.
Channels sharp_marks() {
  Channels channels;
  channels.channels = {{"KP", "V", {}}};
  for (int k = 0; k < 40 * rate_hz / speed_hz; ++k) {
    const double turn = speed_hz * k / rate_hz + 0.7;
    channels.channels[0].values.push_back(turn - std::floor(turn) < 0.2 ? -12 : -2);
  }
  return channels;
}

ShaftTurns turns(const Channels& channels, const Instrument& instrument) {
  std::vector<std::string> findings;
  return turns_of(channels, instrument, {0, rate_hz}, "f.csv", findings);
}

TEST(ShaftTurns, TheTruthLiesWithinTheDoubt) {
  const ShaftTurns found = turns(sharp_marks(), {.keyphasor = Keyphasor{.column = "KP"}});
  const AngleDoubt doubt = angle_doubt_of(found.begin_s, found);
  ASSERT_EQ(doubt.low_turns.size(), found.begin_s.size());
  ASSERT_GE(found.begin_s.size(), 38u);
  EXPECT_GE(doubt.degree, 1);
  for (std::size_t k = 0; k < found.begin_s.size(); ++k) {
    // Angular error of each mark: shaft angle at the assumed mark minus that at the true one.
    const double truth_s = (static_cast<double>(k) + 0.3) / speed_hz;
    const double off_turns = (truth_s - found.begin_s[k]) * speed_hz;
    EXPECT_LE(doubt.low_turns[k], off_turns) << k;
    EXPECT_GE(doubt.high_turns[k], off_turns) << k;
    EXPECT_LE(doubt.high_turns[k] - doubt.low_turns[k], 1.05 * speed_hz / rate_hz) << k;
  }
}

TEST(ShaftTurns, DoubtOfAStretchIsThatOfItsMarks) {
  const ShaftTurns found = turns(sharp_marks(), {.keyphasor = Keyphasor{.column = "KP"}});
  const AngleDoubt all = angle_doubt_of(found.begin_s, found);
  const std::vector<double> stretch{found.begin_s.begin() + 7, found.begin_s.begin() + 20};
  const AngleDoubt some = angle_doubt_of(stretch, found);
  ASSERT_EQ(some.low_turns.size(), 13u);
  for (std::size_t k = 0; k < 13; ++k) EXPECT_NEAR(some.low_turns[k], all.low_turns[k + 7], 1e-4);
}

TEST(ShaftTurns, WithoutAKeyphasorThereIsNoDoubt) {
  const ShaftTurns found = turns(sharp_marks(), {.speed_hz = speed_hz});
  EXPECT_TRUE(angle_doubt_of(found.begin_s, found).low_turns.empty());
}

TEST(ShaftTurns, AThresholdOutsideOfTheSignalIsRefused) {
  try {
    turns(sharp_marks(), {.keyphasor = Keyphasor{.column = "KP", .threshold = -20}});
    FAIL() << "taken";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(
        error.what(),
        "f.csv: 'KP': keyphasor.threshold: is -20, allowed: between -12 and -2, the signal's lowest and "
        "highest value");
  }
}

/// Instants rounded to half a step before the next sample, as for an edge shorter than a step.
std::vector<double> rounded(const std::vector<double>& marks, double step_s) {
  std::vector<double> rounded;
  for (const double t_s : marks) rounded.push_back((std::ceil(t_s / step_s) - 0.5) * step_s);
  return rounded;
}

TEST(ShaftTurnsMarkFit, RoundedMarksComeBackToTheirPlaces) {
  const double step_s = 2e-4;
  for (const double rate : {0.0, 0.5, -0.4}) {
    const auto truth = turns_s(400, 70.1, rate);
    const auto marks = rounded(truth, step_s);
    EXPECT_GT(largest_error(marks, truth), 0.45 * step_s);
    EXPECT_LT(largest_error(smoothed_marks(marks, step_s).t_s, truth), 0.05 * step_s) << rate;
  }
}

TEST(ShaftTurnsMarkFit, FewMarksComeBackToAShareOfASample) {
  // 32 turns with 20 to 200 samples each.
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
  // The error is at most half a sample between mark and curve, plus half a sample between mark and truth.
  EXPECT_LT(errors.back(), 0.5 + smoothing_bound);
}

TEST(ShaftTurnsMarkFit, ASpeedThatSwaysKeepsItsSway) {
  // The marks move by eight steps to and fro every 100 turns.
  const double step_s = 2e-4;
  auto truth = turns_s(800, 70.1, 0);
  for (std::size_t k = 0; k < truth.size(); ++k)
    truth[k] += 8 * step_s * std::sin(2 * pi * static_cast<double>(k) / 100);
  EXPECT_LT(largest_error(smoothed_marks(rounded(truth, step_s), step_s).t_s, truth), 0.6 * step_s);
}

TEST(ShaftTurnsMarkFit, MarksThatNoSmoothCurveExplainsStay) {
  auto marks = turns_s(200, 50, 0);
  for (std::size_t k = 0; k < marks.size(); k += 2) marks[k] += 1e-3;
  EXPECT_EQ(smoothed_marks(marks, 1e-4).t_s, marks);
  EXPECT_EQ(smoothed_marks(marks, 0).t_s, marks);
}

TEST(ShaftTurnsMarkFit, ResolutionIsThatOfTheEdges) {
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
  // The trailing edge is sharp, whatever the leading edge is.
  EXPECT_EQ(mark_resolution(pulses(4), Mark::dark, 0.5), 1);
}

}  // namespace
}  // namespace rubsweep::recording
