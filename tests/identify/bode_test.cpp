#include "rubsweep/identify/bode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::identify {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// Steady response of a Jeffcott rotor of 30 Hz to unbalance, at every speed of a slow run-up, seen along x
/// and y.
struct RunUp {
  std::vector<double> x, y, angle, speed;
};

Complex steady(double hz) {
  const double s = hz / 30;
  return 1e-4 * s * s / Complex(1 - s * s, 2 * 0.02 * s);
}

RunUp slow_run_up() {
  RunUp run;
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

TEST(BodePlot, AmplitudeAndLagOfARotorThroughItsCriticalSpeed) {
  const RunUp run = slow_run_up();
  for (const bool vertical : {false, true}) {
    const auto plot = bode_plot(vertical ? run.y : run.x, run.angle, run.speed, vertical ? 90 : 0, 5);
    ASSERT_GT(plot.size(), 300U);
    for (const BodePoint& point : plot) {
      const Complex expected = steady(point.speed_hz);
      EXPECT_NEAR(point.amplitude_m, std::abs(expected), 0.005 * std::abs(expected)) << point.speed_hz;
      EXPECT_NEAR(point.phase_deg, std::arg(expected) * 180 / pi, 1) << point.speed_hz;
    }
    // The amplitude for unbalance is largest at f / sqrt(1 - 2 zeta^2).
    ASSERT_TRUE(critical_speed_hz(plot));
    EXPECT_NEAR(*critical_speed_hz(plot), 30 / std::sqrt(1 - 2 * 0.02 * 0.02), 0.02);
  }
}

TEST(BodePlot, TooShortForAWindow) {
  const std::vector<double> few{0, 1, 2};
  EXPECT_TRUE(bode_plot(few, few, few, 0, 5).empty());
  EXPECT_FALSE(critical_speed_hz({}));
}

TEST(CriticalSpeed, IsTheTopOfTheParabola) {
  std::vector<BodePoint> plot;
  for (const double hz : {28.0, 29.0, 30.5, 31.0, 33.0})
    plot.push_back({hz, 1 - (hz - 30.2) * (hz - 30.2) / 100, 0});
  ASSERT_TRUE(critical_speed_hz(plot));
  EXPECT_NEAR(*critical_speed_hz(plot), 30.2, 1e-12);
}

TEST(CriticalSpeed, IsNoneAtAnEnd) {
  const std::vector<BodePoint> rising{{10, 1, 0}, {11, 2, 0}, {12, 3, 0}}, falling{{40, 3, 0}, {41, 2, 0}};
  EXPECT_FALSE(critical_speed_hz(rising));
  EXPECT_FALSE(critical_speed_hz(falling));
}

}  // namespace
}  // namespace rubsweep::identify
