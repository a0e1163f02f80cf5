#include "rubsweep/analysis/trace/probe_period.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::trace {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

struct Line {
  double order = 0, amplitude_m = 0;
};

/// Readings of lines, and of noise of this standard deviation in x and in y.
std::vector<Complex> readings(const std::vector<Line>& lines, double speed_hz, double sample_s, int count,
                              double noise_m = 0) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 1);
  std::vector<Complex> z;
  for (int j = 0; j < count; ++j) {
    Complex sum(2e-5, -1e-5);
    for (const Line& line : lines)
      sum += std::polar(line.amplitude_m, 2 * pi * line.order * speed_hz * sample_s * j + line.order);
    z.push_back(sum + noise_m * Complex(noise(random), noise(random)));
  }
  return z;
}

TEST(ProbePeriodFind, IsTheSmallestNumberOfTurnsWhoseLinesExplainTheReadings) {
  for (const double speed_hz : {70.0, 61.3, 133.7}) {
    for (const int n : {1, 2, 3, 5, 12}) {
      const auto z = readings({{1, 4e-4}, {1.0 / n, 1e-3}, {-2.0 / n, 1e-4}}, speed_hz, 1e-3, 1200);
      const ProbePeriod found = find_period(z, 1e-3, speed_hz, 0, 64, 12);
      EXPECT_EQ(found.period, n) << speed_hz;
      EXPECT_LT(found.unexplained_share, 1e-12);
      EXPECT_EQ(found.readings, std::min(1200, static_cast<int>(64 / (1e-3 * speed_hz))));
    }
  }
}

TEST(ProbePeriodFind, OfALineWithoutARatioIsNone) {
  const auto z = readings({{1, 4e-4}, {std::sqrt(0.2), 1e-3}}, 70, 1e-3, 1200);
  const ProbePeriod found = find_period(z, 1e-3, 70, 0, 64, 12);
  EXPECT_FALSE(found.period);
  EXPECT_GT(found.unexplained_share, 1e-3);
}

/// The noise explains what it leaves, and no more.
TEST(ProbePeriodFind, SeesThroughNoiseThatItKnowsOf) {
  const double noise_m = 2e-5;
  const auto z = readings({{1, 4e-4}, {0.5, 3e-4}}, 70, 1e-3, 914, noise_m);
  const ProbePeriod known = find_period(z, 1e-3, 70, noise_m, 64, 12);
  EXPECT_EQ(known.period, 2);
  const double energy = 4e-4 * 4e-4 + 3e-4 * 3e-4;
  EXPECT_NEAR(known.unexplained_share, 2 * noise_m * noise_m / energy, 0.2 * 2 * noise_m * noise_m / energy);
  EXPECT_FALSE(find_period(z, 1e-3, 70, 0, 64, 12).period);
}

/// At 70 rev/s and 1 ms the sampling rate is 100/7 orders: a line at order 10 is read at 10 - 100/7.
TEST(ProbePeriodFind, ALineAboveHalfTheSamplingRateIsFoldedWhereNoLineBelongs) {
  const auto z = readings({{1, 4e-4}, {10, 1e-4}}, 70, 1e-3, 914);
  EXPECT_FALSE(find_period(z, 1e-3, 70, 0, 64, 6).period);
  const auto spectrum = [&] {
    response::spectrum::SpectrumWorkspace workspace;
    return probe_spectrum(z, 1e-3, 70, 64, 1, workspace);
  }();
  const auto at = [&](double order) {
    return spectrum.amplitude(static_cast<int>(std::lround(order * spectrum.turns)));
  };
  EXPECT_EQ(spectrum.turns % 7, 0);
  EXPECT_NEAR(at(1), 4e-4, 1e-12);
  EXPECT_NEAR(at(10 - 100.0 / 7), 1e-4, 1e-12);
}

TEST(ProbePeriodSpectrum, CoversWholePeriods) {
  response::spectrum::SpectrumWorkspace workspace;
  for (const int period : {1, 2, 3}) {
    const auto z = readings({{1, 4e-4}, {1.0 / period, 1e-3}}, 70, 1e-3, 1300);
    const auto spectrum = probe_spectrum(z, 1e-3, 70, 64, period, workspace);
    EXPECT_EQ(spectrum.turns % period, 0);
    EXPECT_GE(spectrum.turns, 32);
    EXPECT_NEAR(spectrum.amplitude(spectrum.turns / period), period == 1 ? 1.4e-3 : 1e-3, 3e-4);
    if (period > 1) {
      EXPECT_NEAR(spectrum.amplitude(spectrum.turns), 4e-4, 1e-12);
      EXPECT_NEAR(spectrum.amplitude(spectrum.turns / period), 1e-3, 1e-12);
    }
  }
  EXPECT_TRUE(probe_spectrum({}, 1e-3, 70, 64, 1, workspace).amplitude_m.empty());
}

TEST(ProbePeriodPairOf, IsTheFirstAtOnePlaceFromTwoDirections) {
  EXPECT_EQ(pair_of({0, 90}, {}), ProbePair(0, 1));
  EXPECT_EQ(pair_of({0, 180, 45}, {0.1, 0.1, 0.1}), ProbePair(0, 2));
  EXPECT_EQ(pair_of({0, 90, 85}, {0.1, 0.2, 0.2}), std::nullopt);
  EXPECT_EQ(pair_of({0, 90, 30}, {0.1, 0.2, 0.2}), ProbePair(1, 2));
  EXPECT_EQ(pair_of({0}, {0.1}), std::nullopt);
}

TEST(ProbePeriodDisplacementOf, UndoesTheDirectionsOfThePair) {
  const std::vector<double> angle_deg{30, -10, 100};
  const Complex z(3e-4, -7e-4);
  Eigen::MatrixXd read(1, 3);
  for (int i = 0; i < 3; ++i) {
    const double angle = angle_deg[static_cast<std::size_t>(i)] * pi / 180;
    read(0, i) = z.real() * std::cos(angle) + z.imag() * std::sin(angle);
  }
  for (const ProbePair& pair : {ProbePair(0, 1), ProbePair(0, 2), ProbePair(1, 2)})
    EXPECT_LT(std::abs(displacement_of(read, pair, angle_deg).at(0) - z), 1e-18);
}

}  // namespace
}  // namespace rubsweep::trace
