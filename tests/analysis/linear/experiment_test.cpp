#include "rubsweep/analysis/linear/experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::linear {
namespace {

TEST(Experiment, FreeResponseFindsTheRotorsFrequencyAndDamping) {
  const FreeResponse response = free_response(scene::prepare_machine(scene::one_side_machine()), 1, {});
  ASSERT_EQ(response.decay.size(), 2u);
  EXPECT_FALSE(response.decay[0]);  // the kick acts along y, so the sensor in x shows nothing
  ASSERT_TRUE(response.decay[1]);
  EXPECT_NEAR(response.decay[1]->natural_frequency_hz, 30, 1e-6);
  EXPECT_NEAR(response.decay[1]->damping_ratio, 0.02, 1e-6);
  EXPECT_EQ(response.signal_m.rows(), 1001);
}

TEST(Experiment, NoiseIsThereAndAlwaysTheSame) {
  const scene::PreparedMachine machine = scene::prepare_machine(scene::one_side_machine());
  const Sampling noisy{.noise_m = 2e-6};
  const FreeResponse first = free_response(machine, 1, noisy), second = free_response(machine, 1, noisy);
  EXPECT_EQ(first.signal_m, second.signal_m);
  EXPECT_NE(first.signal_m, free_response(machine, 1, {}).signal_m);
  ASSERT_TRUE(first.decay[1]);
  EXPECT_NEAR(first.decay[1]->natural_frequency_hz, 30, 0.02);
  EXPECT_NEAR(first.decay[1]->damping_ratio, 0.02, 5e-4);
  EXPECT_FALSE(first.decay[0]);  // noise must not be mistaken for a decay of the rotor
}

TEST(Experiment, RunUpFindsTheResonanceBehindTheLargest1X) {
  const RunUp found = run_up(scene::prepare_machine(scene::one_side_machine()), 27, 34, 0.5, 1e-5, {});
  for (std::size_t sensor = 0; sensor < 2; ++sensor) {
    // A rising speed shifts the peak up by about the rate times the decay time 1 / (zeta w0) = 0.27 s.
    ASSERT_TRUE(found.speed_of_largest_1x_hz[sensor]);
    EXPECT_NEAR(*found.speed_of_largest_1x_hz[sensor], 30.1, 0.2);
    // The steady amplitude at resonance is e / (2 zeta).
    EXPECT_NEAR(found.largest_amplitude_m[sensor], 1e-5 / 0.04, 0.1 * 1e-5 / 0.04);
    EXPECT_GT(found.bode[sensor].size(), 24u);
    ASSERT_TRUE(found.resonance[sensor]);
    EXPECT_NEAR(found.resonance[sensor]->frequency_hz, 30, 1e-5);
    EXPECT_NEAR(found.resonance[sensor]->damping_ratio, 0.02, 1e-6);
  }
  EXPECT_EQ(found.signal_m.rows(), 14001);
}

TEST(Experiment, TheSlowestFreeVibrationIsThatOfTheRotor) {
  EXPECT_NEAR(lowest_frequency_hz(scene::prepare_machine(scene::one_side_machine())), 30, 1e-10);
}

TEST(Experiment, WithoutUnbalanceARunUpHasNoLargest1X) {
  const RunUp found =
      run_up(scene::prepare_machine(scene::one_side_machine()), 27, 34, 5, 0, {.noise_m = 1e-6});
  EXPECT_EQ(found.speed_of_largest_1x_hz, (std::vector<std::optional<double>>{std::nullopt, std::nullopt}));
}

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

TEST(ExperimentFreeDecayFit, RecoversExactSignals) {
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

TEST(ExperimentFreeDecayFit, NoiseMovesItByNoMoreThanNoiseCan) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0, 1e-5);
  std::vector<double> x = decay(30, 0.02, 3e-4, 0, 1000);
  for (double& value : x) value += noise(random);
  const FreeDecay fit = fit_free_decay(x, 1e-3);
  EXPECT_NEAR(fit.natural_frequency_hz, 30, 0.03);
  EXPECT_NEAR(fit.damping_ratio, 0.02, 0.001);
  EXPECT_GT(fit.misfit, 0.01);
}

TEST(ExperimentFreeDecayFit, TakesTheStrongestOfTwoModes) {
  std::vector<double> x = decay(30, 0.01, 3e-4, 0, 2000);
  const std::vector<double> other = decay(188, 0.02, 1e-4, 1, 2000);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += other[k];
  EXPECT_NEAR(fit_free_decay(x, 1e-3).natural_frequency_hz, 30, 0.02);
}

TEST(ExperimentFreeDecayFit, RefusesWhatCannotBeFitted) {
  EXPECT_THROW(fit_free_decay(std::vector<double>(10, 1.0), 1e-3), ConfigError);
  EXPECT_THROW(fit_free_decay(std::vector<double>(100, 1.0), 1e-3), ConfigError);
}

}  // namespace

}  // namespace rubsweep::linear
