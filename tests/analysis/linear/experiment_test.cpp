#include "rubsweep/analysis/linear/experiment.hpp"

#include <gtest/gtest.h>

#include "core/scene/one_side_machine.hpp"

namespace rubsweep::linear {
namespace {

TEST(Experiment, FreeResponseFindsTheRotorsFrequencyAndDamping) {
  const FreeResponse response = free_response(scene::prepare_machine(scene::one_side_machine()), 1, {});
  ASSERT_EQ(response.decay.size(), 2u);
  EXPECT_FALSE(response.decay[0]);  // the kick points along y: x sees nothing
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
  EXPECT_FALSE(first.decay[0]);  // noise is no rotor
}

TEST(Experiment, RunUpFindsTheResonanceBehindTheLargest1X) {
  const RunUp found = run_up(scene::prepare_machine(scene::one_side_machine()), 27, 34, 0.5, 1e-5, {});
  for (std::size_t sensor = 0; sensor < 2; ++sensor) {
    // A rising speed shifts the peak up by about the rate times the memory 1 / (zeta w0) = 0.27 s.
    ASSERT_TRUE(found.speed_of_largest_1x_hz[sensor]);
    EXPECT_NEAR(*found.speed_of_largest_1x_hz[sensor], 30.1, 0.2);
    // Steady: e / (2 zeta).
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

}  // namespace
}  // namespace rubsweep::linear
