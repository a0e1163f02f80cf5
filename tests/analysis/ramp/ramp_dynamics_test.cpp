#include "rubsweep/analysis/ramp/ramp_dynamics.hpp"

#include <gtest/gtest.h>

#include <array>

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::ramp {
namespace {

TEST(RampDynamics, AtTheReferenceSpeedIsThatOfASteadyShaft) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  scene::Scene steady = scene::build_cell(prepared, 40, scene::Eccentricity{2e-4}).scene;
  const double w = steady.speed_rad_per_s;
  steady.harmonic_n = 2e-4 * w * w * prepared.assembly.system.unbalance_kg;
  steady.pulses.clear();
  scene::Scene bare = steady;
  bare.harmonic_n.setZero();
  RampForces forces;
  forces.start_speed = 1;
  forces.unbalance = 2e-4 / 1e-3 *
                     prepared.assembly.system.unbalance_kg.cwiseQuotient(
                         prepared.assembly.system.mass.diagonal().cast<std::complex<double>>());
  const auto scaled = integrate::run::scale<4>(steady), without = integrate::run::scale<4>(bare);
  integrate::law::Dynamics<4, false> expected(scaled, 0);
  RampDynamics<4> found(without, 0, forces);
  // A rotor that penetrates the wall and slides: friction depends on the surface speed.
  const std::array<double, 8> state{0.1, 1.4, 0.02, 0.3, 0.5, 0.2, -0.1, 0.1};
  const double angle = 0.7;
  std::array<double, 10> turning{}, turning_rate{};
  std::copy(state.begin(), state.end(), turning.begin());
  turning[8] = angle;
  turning[9] = 1;
  std::array<double, 8> rate{};
  for (auto* modes : {&expected.modes(), &found.modes()}) modes->front() = contact::Mode::sprung;
  expected(state, rate, angle);
  found(turning, turning_rate, 0.0);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(turning_rate[i], rate[i], 1e-13 * (1 + std::abs(rate[i]))) << i;
  EXPECT_EQ(turning_rate[8], 1);
  EXPECT_EQ(turning_rate[9], 0);
  EXPECT_NEAR(found.slip_m_per_s(0, turning), expected.slip_m_per_s(0, state), 1e-12);
  // At half the shaft speed the surface moves half as fast.
  turning[9] = 0.5;
  EXPECT_NEAR(expected.slip_m_per_s(0, state) - found.slip_m_per_s(0, turning), 0.5 * 0.0375 * w, 1e-12);
}

}  // namespace
}  // namespace rubsweep::ramp
