#include "rubsweep/analysis/linear/bode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Steady unbalance response of a Jeffcott rotor of 30 Hz at every speed of a slow run-up, in x and y.
struct SlowRunUp {
  std::vector<double> x, y, angle, speed;
};

Complex steady(double hz) {
  const double s = hz / 30;
  return 1e-4 * s * s / Complex(1 - s * s, 2 * 0.02 * s);
}

SlowRunUp slow_run_up() {
  SlowRunUp run;
  for (int k = 0; k < 80000; ++k) {
    const double t = 1e-3 * k, hz = 10 + 0.5 * t, phi = 2 * pi * (10 * t + 0.25 * t * t);
    const Complex z = steady(hz) * std::polar(1.0, phi) + Complex(2e-5, -3e-5);
    run.x.push_back(z.real());
    run.y.push_back(z.imag());
    run.angle.push_back(phi);
    run.speed.push_back(hz);
  }
  return run;
}

OneXSignal signal_of(const SlowRunUp& run, std::span<const Complex> phasor, std::span<const double> noise,
                     double sensor_angle_deg) {
  return {phasor, noise, run.angle, run.speed, sensor_angle_deg};
}

TEST(BodeOneX, FitsWhatTheReadingsAddAndTellsTheLag) {
  const SlowRunUp run = slow_run_up();
  const std::vector<Complex> nothing(run.x.size());
  for (const bool vertical : {false, true}) {
    const OneX one = one_x(signal_of(run, nothing, vertical ? run.y : run.x, vertical ? 90 : 0), 5);
    ASSERT_GT(one.plot.size(), 1500U);
    for (const BodePoint& point : one.plot) {
      const Complex expected = steady(point.speed_hz);
      EXPECT_NEAR(point.amplitude_m, std::abs(expected), 0.005 * std::abs(expected)) << point.speed_hz;
      EXPECT_NEAR(point.phase_deg, std::arg(expected) * 180 / pi, 1) << point.speed_hz;
    }
  }
}

TEST(BodeOneX, IsThePhasorAtTheInstantAndItsTopThatOfTheCurve) {
  const SlowRunUp run = slow_run_up();
  std::vector<Complex> phasor;
  for (const double hz : run.speed) phasor.push_back(steady(hz));
  const OneX one = one_x(signal_of(run, phasor, {}, 0), 10);
  for (const BodePoint& point : one.plot) {
    const Complex expected = steady(point.speed_hz);
    EXPECT_NEAR(point.amplitude_m, std::abs(expected), 1e-15);
    EXPECT_NEAR(point.phase_deg, std::arg(expected) * 180 / pi, 1e-9);
  }
  // The amplitude has its maximum e / (2 zeta sqrt(1 - zeta^2)) at f / sqrt(1 - 2 zeta^2).
  ASSERT_TRUE(one.speed_of_largest_hz);
  EXPECT_NEAR(*one.speed_of_largest_hz, 30 / std::sqrt(1 - 2 * 0.02 * 0.02), 1e-6);
  EXPECT_NEAR(one.largest_amplitude_m, 1e-4 / (0.04 * std::sqrt(1 - 0.02 * 0.02)), 1e-13);
}

TEST(BodeOneX, HasNoTopAtAnEnd) {
  const SlowRunUp run = slow_run_up();
  std::vector<Complex> rising, falling;
  for (const double hz : run.speed) {
    rising.emplace_back(hz);
    falling.emplace_back(-100 + hz);
  }
  EXPECT_FALSE(one_x(signal_of(run, rising, {}, 0), 5).speed_of_largest_hz);
  EXPECT_FALSE(one_x(signal_of(run, falling, {}, 0), 5).speed_of_largest_hz);
}

TEST(BodeOneX, TooShortForAWindow) {
  SlowRunUp run{{}, {}, {0, 1, 2}, {1, 1, 1}};
  const std::vector<Complex> few(3);
  EXPECT_TRUE(one_x(signal_of(run, few, {}, 0), 5).plot.empty());
  EXPECT_TRUE(one_x({}, 5).plot.empty());
}

}  // namespace
}  // namespace rubsweep::linear
