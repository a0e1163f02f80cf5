#include "rubsweep/core/integrate/taylor/step_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "support/annular_scene.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;

TEST(StepLength, FastestRateOfAMassBetweenStructureAndWall) {
  // The shaft turns at 1 rad/s. A mass of 1 kg has a spring of 4 N/m; the wall adds 12 N/m when sprung and
  // 2 x 12 N/m when clamped.
  auto scene = test::one_mass_scene(1, 4, 0, 2 * std::numbers::pi, 1);
  scene.contacts.push_back(test::wall_across_x(1, 1, 12, 0.5));
  const auto system = run::scale<2>(scene);
  const Expansion<2> motion(system);
  EXPECT_NEAR(fastest_rate(2, motion, {Mode::open}), 2, 1e-15);
  EXPECT_NEAR(fastest_rate(2, motion, {Mode::sprung}), 4, 1e-15);
  EXPECT_NEAR(fastest_rate(2, motion, {Mode::clamped}), std::sqrt(28.0), 1e-15);
}

TEST(StepLength, AnOverdampedContactIsAsFastAsItsDamping) {
  auto scene = test::one_mass_scene(1, 4, 0, 2 * std::numbers::pi, 1);
  scene.contacts.push_back(test::wall_across_x(1, 1, 12, 100));
  const auto system = run::scale<2>(scene);
  EXPECT_NEAR(fastest_rate(2, Expansion<2>(system), {Mode::sprung}), 101, 1e-12);
}

TEST(StepLength, WhatTheTangentsOrderLeavesOutOfAnExponentialIsTheAccuracy) {
  for (const double accuracy : {1e-12, 1e-9, 1e-6}) {
    const double x = longest_times_fastest_of_tangents(accuracy);
    double term = 1, sum = 1;
    for (int k = 1; k <= TangentExpansion<2>::order; ++k) sum += term *= x / k;
    // The first omitted term equals the accuracy; the others together are smaller.
    EXPECT_GT(std::exp(x) - sum, 0.9 * accuracy - 1e-14);
    EXPECT_LT(std::exp(x) - sum, 1.5 * accuracy + 1e-14);
  }
  EXPECT_EQ(longest_times_fastest_of_tangents(1e6), longest_times_fastest);
}

TEST(StepLength, TheNormalOfACircleTurnsAsFastAsTheMassGoesRound) {
  const auto scene = test::annular_scene(1, 0, 1, 0, 0, 10, 0.1);
  const auto system = run::scale<2>(scene);
  Expansion<2> motion(system);
  run::PulseTimes no_pulses(scene, run::state_scale(scene), 2 * std::numbers::pi);
  const std::vector<double> state{1.5, 0, 0, -0.6};
  motion.expand(state.data(), 0, no_pulses, {Mode::sprung}, {contact::Slip::forward});
  EXPECT_NEAR(fastest_normal(motion, {Mode::sprung}), 0.4, 1e-15);
  EXPECT_EQ(fastest_normal(motion, {Mode::open}), 0);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
