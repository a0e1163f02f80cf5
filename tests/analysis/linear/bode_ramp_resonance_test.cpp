#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

#include "rubsweep/analysis/linear/bode.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

struct Rotor {
  double natural_hz = 30, damping_ratio = 0.01;
  Complex eccentricity_m = 1e-5, bow_m = 0, rest_m = 0;
};

/// 1X once per revolution, by the classical Runge-Kutta method with small fixed steps in the fixed frame. It
/// starts on the quiet motion of the first speed without the bow, so a free vibration is included.
std::vector<BodePoint> plot_of_ramp(const Rotor& rotor, double from_hz, double to_hz, double rate_hz_per_s) {
  const double w = 2 * pi * rotor.natural_hz, damping = 2 * rotor.damping_ratio * w, h = 1e-4;
  const auto speed = [&](double t) { return 2 * pi * (from_hz + rate_hz_per_s * t); };
  const auto angle = [&](double t) { return 2 * pi * (from_hz * t + rate_hz_per_s * t * t / 2); };
  const auto acceleration = [&](double t, Complex q, Complex v) {
    const Complex centrifugal =
        rotor.eccentricity_m * Complex(speed(t) * speed(t), -2 * pi * rate_hz_per_s) + rotor.bow_m * w * w;
    return centrifugal * std::polar(1.0, angle(t)) - damping * v - w * w * q;
  };
  const double first = speed(0);
  Complex q = rotor.eccentricity_m * first * first / Complex(w * w - first * first, damping * first);
  Complex v = Complex(0, first) * q;
  std::vector<BodePoint> plot;
  const auto steps = static_cast<long>((to_hz - from_hz) / rate_hz_per_s / h);
  for (long k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k) * h;
    if (angle(t) >= 2 * pi * static_cast<double>(plot.size())) {
      const Complex phasor = q * std::polar(1.0, -angle(t)) + rotor.rest_m;
      plot.push_back({from_hz + rate_hz_per_s * t, std::abs(phasor), std::arg(phasor) * 180 / pi});
    }
    const Complex a1 = acceleration(t, q, v), a2 = acceleration(t + h / 2, q + h / 2 * v, v + h / 2 * a1);
    const Complex a3 = acceleration(t + h / 2, q + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2);
    const Complex a4 = acceleration(t + h, q + h * v + h * h / 2 * a2, v + h * a3);
    q += h * v + h * h / 6 * (a1 + a2 + a3);
    v += h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  }
  return plot;
}

double speed_of_largest_hz(const std::vector<BodePoint>& plot) {
  return std::ranges::max_element(plot, {}, &BodePoint::amplitude_m)->speed_hz;
}

TEST(BodeRampResonance, IsThatOfTheRotorHoweverFastTheRamp) {
  for (const auto& [ratio, rate] :
       {std::pair{0.01, 4.0}, {0.01, -4.0}, {0.01, 24.0}, {0.001, 4.0}, {0.1, 4.0}}) {
    const auto plot = rate > 0 ? plot_of_ramp({.damping_ratio = ratio}, 15, 45, rate)
                               : plot_of_ramp({.damping_ratio = ratio}, 45, 15, rate);
    const auto fit = fit_ramp_resonance(plot, rate);
    ASSERT_TRUE(fit) << ratio << ' ' << rate;
    EXPECT_NEAR(fit->frequency_hz, 30, 3e-5) << ratio << ' ' << rate;
    EXPECT_NEAR(fit->damping_ratio, ratio, 1e-6 * ratio) << ratio << ' ' << rate;
    EXPECT_LT(fit->misfit, 1e-8);
    // The speed of the largest 1X is a worse estimate.
    EXPECT_GT(std::abs(speed_of_largest_hz(plot) - 30), 0.5);
  }
}

TEST(BodeRampResonance, AllowsForABowAndForOtherModes) {
  const auto plot = plot_of_ramp({.bow_m = {4e-6, 7e-6}, .rest_m = {3e-6, -1e-6}}, 15, 45, 4);
  const auto fit = fit_ramp_resonance(plot, 4);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->frequency_hz, 30, 3e-5);
  EXPECT_NEAR(fit->damping_ratio, 0.01, 1e-7);
}

TEST(BodeRampResonance, NoiseIsLeftAsMisfit) {
  auto plot = plot_of_ramp({}, 15, 45, 4);
  double largest_m = 0;
  for (const BodePoint& point : plot) largest_m = std::max(largest_m, point.amplitude_m);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.01 * largest_m);
  for (BodePoint& point : plot) {
    const Complex phasor =
        std::polar(point.amplitude_m, point.phase_deg * pi / 180) + Complex(noise(random), noise(random));
    point.amplitude_m = std::abs(phasor);
    point.phase_deg = std::arg(phasor) * 180 / pi;
  }
  const auto fit = fit_ramp_resonance(plot, 4);
  ASSERT_TRUE(fit);
  // About 0.1 % of the frequency and 10 % of the damping ratio.
  EXPECT_NEAR(fit->frequency_hz, 30, 0.09);
  EXPECT_NEAR(fit->damping_ratio, 0.01, 3e-3);
  // Both components have 1 % noise; the signal's root mean square is about half its maximum.
  EXPECT_NEAR(fit->misfit, 0.01 * std::sqrt(2.0) / 0.55, 0.01);
}

TEST(BodeRampResonance, TwoModesLeaveAMisfit) {
  auto plot = plot_of_ramp({}, 15, 45, 4);
  const auto second = plot_of_ramp({.natural_hz = 31.5}, 15, 45, 4);
  for (std::size_t k = 0; k < plot.size(); ++k) {
    const Complex sum = std::polar(plot[k].amplitude_m, plot[k].phase_deg * pi / 180) -
                        std::polar(second[k].amplitude_m, second[k].phase_deg * pi / 180);
    plot[k].amplitude_m = std::abs(sum);
    plot[k].phase_deg = std::arg(sum) * 180 / pi;
  }
  const auto fit = fit_ramp_resonance(plot, 4);
  EXPECT_TRUE(!fit || fit->misfit > 0.05);
}

TEST(BodeRampResonance, IsEmptyWhereThereIsNothingToFit) {
  EXPECT_FALSE(fit_ramp_resonance({}, 4));
  const auto plot = plot_of_ramp({}, 15, 45, 4);
  EXPECT_FALSE(fit_ramp_resonance(std::span(plot).first(12), 4));
  EXPECT_FALSE(fit_ramp_resonance(plot, -4));  // the speed changes in the opposite direction
  const std::vector<BodePoint> still(40, BodePoint{20, 0, 0});
  EXPECT_FALSE(fit_ramp_resonance(still, 4));
}

}  // namespace
}  // namespace rubsweep::linear
