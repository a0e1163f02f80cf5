#include "rubsweep/analysis/linear/free_decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;

std::vector<double> decay(double hz, double ratio, double amplitude, double phase, int samples,
                          double offset = 0) {
  std::vector<double> x;
  for (int k = 0; k < samples; ++k) {
    const double t = 1e-3 * k, w = 2 * pi * hz;
    x.push_back(offset + amplitude * std::exp(-ratio * w * t) *
                             std::cos(w * std::sqrt(1 - ratio * ratio) * t + phase));
  }
  return x;
}

TEST(FreeDecayFit, RecoversExactSignals) {
  for (const double hz : {7.3, 30.0, 140.0}) {
    for (const double ratio : {0.0, 0.001, 0.02, 0.2}) {
      const FreeDecay fit = fit_free_decay(decay(hz, ratio, 3e-4, 0.7, 1000, 1e-4), 1e-3);
      EXPECT_NEAR(fit.natural_frequency_hz, hz, 1e-7 * hz) << hz << ' ' << ratio;
      EXPECT_NEAR(fit.damping_ratio, ratio, 1e-7) << hz << ' ' << ratio;
      EXPECT_NEAR(fit.amplitude_m, 3e-4, 1e-10);
      EXPECT_LT(fit.misfit, 1e-6);
    }
  }
}

TEST(FreeDecayFit, NoiseMovesItByNoMoreThanNoiseCan) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0, 1e-5);
  std::vector<double> x = decay(30, 0.02, 3e-4, 0, 1000);
  for (double& value : x) value += noise(random);
  const FreeDecay fit = fit_free_decay(x, 1e-3);
  EXPECT_NEAR(fit.natural_frequency_hz, 30, 0.03);
  EXPECT_NEAR(fit.damping_ratio, 0.02, 0.001);
  EXPECT_GT(fit.misfit, 0.01);
}

TEST(FreeDecayFit, TakesTheStrongestOfTwoModes) {
  std::vector<double> x = decay(30, 0.01, 3e-4, 0, 2000);
  const std::vector<double> other = decay(188, 0.02, 1e-4, 1, 2000);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += other[k];
  EXPECT_NEAR(fit_free_decay(x, 1e-3).natural_frequency_hz, 30, 0.02);
}

TEST(FreeDecayFit, RefusesWhatCannotBeFitted) {
  EXPECT_THROW(fit_free_decay(std::vector<double>(10, 1.0), 1e-3), ConfigError);
  EXPECT_THROW(fit_free_decay(std::vector<double>(100, 1.0), 1e-3), ConfigError);
}

}  // namespace
}  // namespace rubsweep::linear
