#include "rubsweep/measurement/recording/integrated.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::recording {
namespace {

using std::numbers::pi;

constexpr double rate_hz = 4000, speed_hz = 40;

/// Derivative of a cosine of this order and 1 m, with an offset and a drift.
std::vector<double> derivative(int times, double order, std::size_t count, double offset, double drift = 0) {
  std::vector<double> readings;
  const double omega = 2 * pi * speed_hz * order;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) / rate_hz;
    readings.push_back(std::pow(omega, times) * std::cos(omega * t + 0.3 + times * pi / 2) + offset +
                       drift * t);
  }
  return readings;
}

double largest_error(const std::vector<double>& values, double order, std::size_t first, std::size_t end) {
  double mean = 0, largest = 0;
  std::vector<double> off;
  for (std::size_t k = first; k < end; ++k) {
    off.push_back(values[k] - std::cos(2 * pi * speed_hz * order * static_cast<double>(k) / rate_hz + 0.3));
    mean += off.back() / static_cast<double>(end - first);
  }
  for (const double value : off) largest = std::max(largest, std::abs(value - mean));
  return largest;
}

TEST(Integrated, IsTheDisplacementWithoutItsMean) {
  for (const int times : {1, 2}) {
    // Forty turns in windows of twenty, and eight turns in one window.
    EXPECT_LT(largest_error(integrated(derivative(times, 1, 4000, 30), rate_hz, times, 0.5), 1, 0, 4000),
              1e-4);
    EXPECT_LT(largest_error(integrated(derivative(times, 1, 800, -30), rate_hz, times, 0.5), 1, 0, 800),
              5e-3);
    EXPECT_LT(largest_error(integrated(derivative(times, 3.3, 4000, 0), rate_hz, times, 0.5), 3.3, 0, 4000),
              1e-4);
    // A slow drift of the instrument is lost within a window of each end.
    EXPECT_LT(largest_error(integrated(derivative(times, 1, 8000, 1, 5), rate_hz, times, 0.5), 1, 2000, 6000),
              1e-3);
  }
}

TEST(Integrated, KeepsOrdersFromTheLowestOneOn) {
  for (const int times : {1, 2}) {
    const double window_s = 0.8, lowest = kept_periods[times] / (window_s * speed_hz);
    for (const double order : {lowest, 1.5 * lowest, 4 * lowest}) {
      const auto values = integrated(derivative(times, order, 12800, 0), rate_hz, times, window_s);
      double squares = 0;
      for (const double value : values) squares += 2 * value * value / 12800;
      EXPECT_NEAR(std::sqrt(squares), 1, 0.015) << times << ' ' << order;
    }
    const auto lost = integrated(derivative(times, lowest / 20, 12800, 0), rate_hz, times, window_s);
    double squares = 0;
    for (const double value : lost) squares += 2 * value * value / 12800;
    EXPECT_LT(std::sqrt(squares), 0.1);
  }
}

TEST(Integrated, NoiseFallsWithTheOrder) {
  const Integration velocity{1, 0.2}, acceleration{2, 0.2};
  EXPECT_EQ(Integration{}.noise_at(5), 1);
  EXPECT_EQ(velocity.noise_at(-4), 0.25);
  EXPECT_NEAR(acceleration.noise_at(0.5), 4, 1e-12);
  EXPECT_NEAR(acceleration.noise_at(0), 25, 1e-9);
}

TEST(Integrated, GapsStayGaps) {
  auto readings = derivative(1, 1, 4000, 3);
  readings[1000] = NAN;
  readings[1008] = NAN;  // seven readings between two gaps are a gap
  const auto values = integrated(readings, rate_hz, 1, 0.4);
  for (std::size_t k = 1000; k <= 1008; ++k) EXPECT_TRUE(std::isnan(values[k]));
  EXPECT_LT(largest_error(values, 1, 0, 1000), 5e-3);
  EXPECT_LT(largest_error(values, 1, 1009, 4000), 1e-3);
  EXPECT_TRUE(integrated({}, rate_hz, 2, 0.4).empty());
}

}  // namespace
}  // namespace rubsweep::recording
