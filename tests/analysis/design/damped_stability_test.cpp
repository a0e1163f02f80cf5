#include "rubsweep/analysis/design/damped_stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/scene/kit_machine.hpp"

namespace rubsweep::design {
namespace {

using std::numbers::pi;

TEST(DampedStability, CrossCouplingIsPowerBySpeedAndSizes) {
  // 1 MW at 6000 rpm: 1591.5 N m.
  EXPECT_NEAR(cross_coupling_n_per_m({false, 1e6, 2, 0.4, 0.02}, 100), 3 * 2 * 1591.549 / (0.4 * 0.02), 1);
  EXPECT_NEAR(cross_coupling_n_per_m({true, 1e6, 1, 0.4, 0.02}, 100), 1.5 * 1591.549 / (0.4 * 0.02), 1);
}

/// The motion z = x + i y of a disc obeys m z'' + c z' + (k - i coupling) z = 0. It neither decays nor grows
/// if the coupling is c w, with the natural frequency w.
TEST(DampedStability, OfADiscIsItsClosedForm) {
  const linear::FreeRotor disc = linear::free_rotor(scene::one_side_machine());
  const double zeta = 0.02, w = 2 * pi * 30, mass_kg = 0.8, threshold = 2 * zeta * mass_kg * w * w;
  const auto free = first_forward(disc, std::vector{100.0}, 200);
  ASSERT_TRUE(free);
  EXPECT_NEAR(free->decrement, 2 * pi * zeta / std::sqrt(1 - zeta * zeta), 1e-9);
  EXPECT_NEAR(free->frequency_hz, 30 * std::sqrt(1 - zeta * zeta), 1e-9);
  EXPECT_NEAR(threshold_n_per_m(disc, 100, 200, 0).value(), threshold, 1e-9 * threshold);
  const double coupling = 0.4 * threshold;
  // Characteristic equation with rate s: m s^2 + c s + k - i coupling = 0.
  const std::complex<double> c = 2 * zeta * mass_kg * w, k(mass_kg * w * w, -coupling);
  const std::complex<double> rate = (-c + std::sqrt(c * c - 4 * mass_kg * k)) / (2 * mass_kg);
  const std::complex<double> forward =
      rate.imag() > 0 ? rate : (-c - std::sqrt(c * c - 4 * mass_kg * k)) / (2 * mass_kg);
  EXPECT_NEAR(first_forward(disc, std::vector{100.0}, 200, 0, coupling)->decrement,
              -2 * pi * forward.real() / forward.imag(), 1e-9);
  EXPECT_LT(first_forward(disc, std::vector{100.0}, 200, 0, 1.01 * threshold)->decrement, 0);
}

TEST(DampedStability, WhirlThatGrowsByItselfHasNoThreshold) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).rotating_damping_ratio = 0.05;
  EXPECT_EQ(threshold_n_per_m(linear::free_rotor(machine), 100, 200, 0), 0.0);
}

}  // namespace
}  // namespace rubsweep::design
