#include "rubsweep/measurement/scope/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "measurement/scope/samples.hpp"

namespace rubsweep::scope {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
using response::spectrum::OrbitKind;
using response::spectrum::WhirlKind;

struct Line {
  double order = 0;
  Complex amplitude_m = 0;
};

std::vector<Complex> motion(int turns, const std::vector<Line>& lines, double noise_m = 0,
                            unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 1);
  std::vector<Complex> z(static_cast<std::size_t>(turns * samples));
  for (std::size_t k = 0; k < z.size(); ++k) {
    for (const Line& line : lines)
      z[k] += line.amplitude_m * std::polar(1.0, 2 * pi * line.order * static_cast<double>(k) / samples);
    z[k] += noise_m * Complex(noise(random), noise(random));
  }
  return z;
}

const std::vector<Line> ellipse{{0, {1e-3, -1e-3}}, {1, 1e-4}, {-1, {0, 2e-5}}};

TEST(Verdict, LinesAndNoiseAreThoseThatWerePutIn) {
  const Verdict verdict = judge(motion(100, ellipse, 2e-6), samples, true);
  EXPECT_EQ(verdict.motion, MeasuredClass::synchronous);
  EXPECT_EQ(verdict.period, 1);
  EXPECT_EQ(verdict.shape, OrbitKind::oval);
  EXPECT_EQ(verdict.whirl, WhirlKind::forward);
  // White noise gives sigma / sqrt(N) in each component of a line.
  const double expected_m = 2e-6 / std::sqrt(100.0 * samples);
  EXPECT_NEAR(verdict.noise_m, expected_m, 0.1 * expected_m);
  EXPECT_NEAR(verdict.forward_share, 1 / 1.04, 4 * verdict.forward_share_uncertainty);
  for (const MeasuredLine& line : verdict.lines) {
    Complex truth = 0;
    for (const Line& put : ellipse)
      if (put.order == line.order) truth = put.amplitude_m;
    EXPECT_LT(std::abs(line.amplitude_m - truth), 5 * expected_m) << line.order;
  }
}

TEST(Verdict, TheForwardShareSpreadsAsItsUncertaintySays) {
  double sum = 0;
  constexpr int trials = 60;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const Verdict verdict = judge(motion(24, ellipse, 5e-6, seed), samples, true);
    sum += std::pow((verdict.forward_share - 1 / 1.04) / verdict.forward_share_uncertainty, 2);
  }
  EXPECT_NEAR(sum / trials, 1, 0.45);
}

TEST(Verdict, FindsThePeriodWhereItsLinesStandOutOfTheNoise) {
  for (const int n : {2, 3, 4, 5, 8}) {
    auto lines = ellipse;
    lines.push_back({-1.0 / n, 2e-6});
    const Verdict verdict = judge(motion(90, lines, 2e-6), samples, true);
    EXPECT_EQ(verdict.motion, MeasuredClass::subharmonic) << n;
    EXPECT_EQ(verdict.period, n);
  }
}

TEST(Verdict, FalseAlarmsAreRare) {
  int alarms = 0;
  for (unsigned seed = 1; seed <= 100; ++seed)
    alarms += judge(motion(48, ellipse, 2e-5, seed), samples, true).motion != MeasuredClass::synchronous;
  EXPECT_LE(alarms, 6);
}

TEST(Verdict, SaysHowMuchLongerWouldTell) {
  // The line is below the visible limit in 24 turns and above the level that noise reaches in a fifth of the
  // recordings. Without noise in this line the answer is (visible / amplitude)^2.
  const double noise_m = 2e-5, line_noise_m = noise_m / std::sqrt(24.0 * samples);
  auto lines = ellipse;
  lines.push_back({0.5, 4.2 * line_noise_m});
  int doubtful = 0, told = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const Verdict verdict = judge(motion(24, lines, noise_m, seed), samples, true);
    if (verdict.period == 2) ++told;
    if (!verdict.doubtful) continue;
    ++doubtful;
    EXPECT_GT(verdict.doubtful->more_turns, 0);
    EXPECT_LT(verdict.doubtful->more_turns, 24);
    EXPECT_LT(verdict.doubtful->amplitude_m, verdict.visible_m);
  }
  EXPECT_GT(doubtful, 8);
  EXPECT_GT(told, 4);
  // A recording three times longer decides almost always.
  int later = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
    later += judge(motion(72, lines, noise_m, seed), samples, true).period == 2;
  EXPECT_GT(later, 36);
}

TEST(Verdict, AMotionWithoutPeriod) {
  auto lines = ellipse;
  lines.push_back({std::sqrt(0.2), 3e-5});
  const Verdict steady = judge(motion(200, lines), samples, true);
  EXPECT_EQ(steady.motion, MeasuredClass::quasi_periodic);
  EXPECT_FALSE(steady.period);
  auto changing = motion(100, lines);
  lines.back().order = 0.8;
  const auto later = motion(100, lines);
  changing.insert(changing.end(), later.begin(), later.end());
  EXPECT_EQ(judge(changing, samples, true).motion, MeasuredClass::aperiodic);
}

TEST(Verdict, NoiseAloneIsAtRestAndOneProbeHasNoWhirl) {
  EXPECT_EQ(judge(motion(40, {}, 1e-6), samples, true).motion, MeasuredClass::at_rest);
  auto z = motion(40, ellipse, 1e-6);
  for (Complex& value : z) value = value.real();
  const Verdict verdict = judge(z, samples, false);
  EXPECT_EQ(verdict.motion, MeasuredClass::synchronous);
  EXPECT_FALSE(verdict.shape || verdict.whirl);
}

TEST(Verdict, AShortRecordingTellsFewPeriods) {
  EXPECT_EQ(judge(motion(7, ellipse), samples, true).longest_period, 2);
  EXPECT_EQ(judge(motion(24, ellipse), samples, true).longest_period, 8);
}

}  // namespace
}  // namespace rubsweep::scope
