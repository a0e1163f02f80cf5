#include "rubsweep/core/integrate/law/dynamics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <vector>

#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::law {
namespace {

using test::OneSideEquations;
using test::OneSideRotor;
using test::OneSideState;

constexpr int n = 4;
constexpr std::size_t states = 2 * std::size_t{n};

/// Random scaled states around the wall of parameter set A; all modes occur.
std::vector<double> random_state(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<double> s(states);
  for (double& value : s) value = 0.3 * normal(random);
  s[1] = 1 + s[3] + 0.01 * normal(random);
  return s;
}

OneSideState<double> in_si(const std::vector<double>& s, const OneSideRotor& rotor) {
  OneSideState<double> si;
  const double w = 2 * std::numbers::pi * rotor.speed_hz;
  for (std::size_t i = 0; i < si.size(); ++i) si[i] = s[i] * rotor.clearance_m * (i < n ? 1 : w);
  return si;
}

contact::Mode mode_at(const run::ScaledSystem<n>& system, const std::vector<double>& s) {
  const auto& c = system.contacts[0];
  return contact::mode_of(c.stiffness, c.damping, s[1] - s[3] - c.clearance, s[5] - s[7]);
}

TEST(Dynamics, EqualTheHandWrittenEquationsInEveryMode) {
  OneSideRotor rotor;
  rotor.friction_steepness_s_per_m = 0.05;  // flat enough for the slip to matter
  const OneSideEquations<double> equations(rotor);
  const auto scene = test::cell_of(rotor).scene;
  const auto system = run::scale<n>(scene);
  Dynamics<n, false> dynamics(system, 0);
  run::PulseTimes pulses(scene, system.scale, 2 * std::numbers::pi);
  pulses.begin_turn(0);
  dynamics.follow(pulses);
  const double w = 2 * std::numbers::pi * rotor.speed_hz;
  std::mt19937 random(1);
  std::array<int, contact::mode_count> seen{};
  for (int trial = 0; trial < 400; ++trial) {
    const auto s = random_state(random);
    const double phase = std::uniform_real_distribution<double>(0, rotor.kick_s * w)(random);
    dynamics.modes()[0] = mode_at(system, s);
    ++seen[static_cast<std::size_t>(dynamics.modes()[0])];
    std::vector<double> rate(states);
    dynamics(s, rate, phase);
    OneSideState<double> expected;
    equations(in_si(s, rotor), expected, phase / w);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(rate[i], s[i + n]);
      const double scaled = expected[i + n] / (rotor.clearance_m * w * w);
      EXPECT_NEAR(rate[i + n], scaled, 1e-11 * (1 + std::abs(scaled))) << "coordinate " << i;
    }
  }
  for (const int count : seen) EXPECT_GT(count, 10);
}

TEST(Dynamics, FrictionRatioIsTheRateOfTheSlipOverTheFrequencyOfTheContact) {
  // Linearised friction m v' = -mu'(v) K p (v - v0), compared with the contact m p'' = -K p.
  const double m = 2, stiffness = 5e4, p = 1e-4, limit = 0.3, steepness = 40, speed = 0.01;
  auto scene = test::one_mass_scene(m, 100, 0, 0.1, 1e-3);
  scene.contacts.push_back(test::wall_across_x(1, 1e-3, stiffness, 10));
  scene.contacts[0].friction = model::StribeckFriction{{0, 0, 0, limit, steepness, 0}};
  scene.displacement_m << 1e-3 + p, 0;
  scene.velocity_m_per_s << 0, speed;
  const auto system = run::scale<2>(scene);
  const std::vector<double> state = run::scaled_initial_state(scene);
  Dynamics<2, false> located(system, 0);
  EXPECT_EQ(located.friction_ratio(state), 0);  // open
  located.modes()[0] = contact::Mode::sprung;
  const double slope = limit * steepness / std::pow(std::cosh(steepness * speed), 2);
  const double expected = slope * stiffness * p / m / std::sqrt(stiffness / m);
  EXPECT_NEAR(located.friction_ratio(state), expected, 1e-12 * expected);
  const Dynamics<2, true> smoothed(system, 1e-4);
  EXPECT_NEAR(smoothed.friction_ratio(state), expected, 1e-12 * expected);
  // Friction that decreases with the slip drives the motion, but is not stiff.
  scene.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0, 0, -0.1}};
  const auto falling = run::scale<2>(scene);
  Dynamics<2, false> driven(falling, 0);
  driven.modes()[0] = contact::Mode::sprung;
  EXPECT_EQ(driven.friction_ratio(state), 0);
}

TEST(Dynamics, DynamicSizeEqualsFixedSize) {
  const auto cell = test::cell_of({});
  const auto fixed = run::scale<n>(cell.scene);
  const auto dynamic = run::scale<Eigen::Dynamic>(cell.scene);
  Dynamics<n, false> a(fixed, 0);
  Dynamics<Eigen::Dynamic, false> b(dynamic, 0);
  std::mt19937 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const auto s = random_state(random);
    a.modes()[0] = b.modes()[0] = mode_at(fixed, s);
    std::vector<double> rate_a(states), rate_b(states);
    a(s, rate_a, 1.0);
    b(s, rate_b, 1.0);
    for (std::size_t i = 0; i < rate_a.size(); ++i)
      EXPECT_NEAR(rate_a[i], rate_b[i], 1e-12 * (1 + std::abs(rate_a[i])));
  }
}

/// Compares the Jacobian with central differences of the right-hand side.
template <bool Smoothed>
void check_jacobian() {
  OneSideRotor rotor;
  rotor.friction_steepness_s_per_m = 0.05;
  auto scene = test::cell_of(rotor).scene;
  scene.pulses.push_back(scene.pulses.front());
  scene.pulses.front().elapsed_s = 0.1 / scene.speed_rad_per_s;
  const auto system = run::scale<n>(scene);
  Dynamics<n, Smoothed> dynamics(system, 2e-2);
  run::PulseTimes pulses(scene, system.scale, 2 * std::numbers::pi);
  pulses.begin_turn(0);
  ASSERT_EQ(pulses.acting().size(), 2u);
  dynamics.follow(pulses);
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    auto s = random_state(random);
    const double phase = 0.7, h = 1e-6;
    dynamics.modes()[0] = mode_at(system, s);
    Eigen::MatrixXd jacobian_storage(2 * n, 2 * n);
    const auto jacobian = [&](std::size_t row, std::size_t column) -> double& {
      return jacobian_storage(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
    };
    std::vector<double> phase_rate(states), plus(states), minus(states);
    dynamics.jacobian(s, jacobian, phase, phase_rate);
    const double size = jacobian_storage.cwiseAbs().maxCoeff();
    for (std::size_t j = 0; j < states; ++j) {
      const double middle = s[j];
      s[j] = middle + h;
      dynamics(s, plus, phase);
      s[j] = middle - h;
      dynamics(s, minus, phase);
      s[j] = middle;
      for (std::size_t i = 0; i < states; ++i) {
        EXPECT_NEAR(jacobian(i, j), (plus[i] - minus[i]) / (2 * h), 1e-4 * size);
      }
    }
    dynamics(s, plus, phase + h);
    dynamics(s, minus, phase - h);
    for (std::size_t i = 0; i < states; ++i) EXPECT_NEAR(phase_rate[i], (plus[i] - minus[i]) / (2 * h), 1e-6);
  }
}

TEST(Dynamics, JacobianOfEveryMode) { check_jacobian<false>(); }
TEST(Dynamics, JacobianOfTheSmoothedLaw) { check_jacobian<true>(); }

/// A force that changes with time changes the friction that holds a contact as well.
TEST(Dynamics, JacobianOfAStickingContactHasTheChangeOfItsFriction) {
  auto scene = test::one_mass_scene(2, 100, 1, 0.1, 1e-3);
  scene.harmonic_n << 0.3, std::complex<double>(0.1, -0.3);
  scene.contacts.push_back(test::wall_across_x(1, 1e-3, 5e4, 10));
  scene.contacts[0].friction = model::ConstantFriction{0.4};
  scene.displacement_m << 1.2e-3, 0;
  const auto system = run::scale<2>(scene);
  Dynamics<2, false> dynamics(system, 0);
  dynamics.modes()[0] = contact::Mode::sprung;
  dynamics.slips()[0] = contact::Slip::sticking;
  const std::vector<double> state = run::scaled_initial_state(scene);
  const double phase = 0.7, h = 1e-6;
  std::vector<double> by_phase(4), plus(4), minus(4);
  Eigen::MatrixXd by_state(4, 4);
  const auto entry = [&](std::size_t row, std::size_t column) -> double& {
    return by_state(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  };
  dynamics.jacobian(state, entry, phase, by_phase);
  dynamics(state, plus, phase + h);
  dynamics(state, minus, phase - h);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(by_phase[i], (plus[i] - minus[i]) / (2 * h), 1e-7) << i;
  EXPECT_NE(by_phase[2], 0);
}

TEST(DynamicsScaledSystem, RefusesTheWrongSize) {
  EXPECT_THROW(run::scale<2>(test::cell_of({}).scene), std::logic_error);
}

}  // namespace
}  // namespace rubsweep::integrate::law
