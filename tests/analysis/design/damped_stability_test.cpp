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

/// Over the coupling, a disc's decrement falls along the root of its characteristic equation and passes 0 at
/// the threshold; that of a kit is the one of each coupling by itself.
TEST(DampedStability, OverCouplingFollowsTheFirstForwardWhirl) {
  const linear::FreeRotor disc = linear::free_rotor(scene::one_side_machine());
  const double zeta = 0.02, w = 2 * pi * 30, mass_kg = 0.8, threshold = 2 * zeta * mass_kg * w * w;
  const std::vector<double> couplings{0, 0.5 * threshold, threshold, 1.5 * threshold};
  const std::vector<Decrement> found = over_coupling(disc, 100, 200, 0, couplings);
  ASSERT_EQ(found.size(), couplings.size());
  for (std::size_t i = 0; i < couplings.size(); ++i) {
    const std::complex<double> c = 2 * zeta * mass_kg * w, k(mass_kg * w * w, -couplings[i]);
    const std::complex<double> rate = (-c + std::sqrt(c * c - 4 * mass_kg * k)) / (2 * mass_kg),
                               other = (-c - std::sqrt(c * c - 4 * mass_kg * k)) / (2 * mass_kg);
    const std::complex<double> forward = rate.imag() > 0 ? rate : other;
    EXPECT_NEAR(found[i].decrement, -2 * pi * forward.real() / forward.imag(), 1e-9) << couplings[i];
    EXPECT_NEAR(found[i].frequency_hz, forward.imag() / (2 * pi), 1e-9);
  }
  EXPECT_NEAR(found[2].decrement, 0, 1e-9);
  const linear::FreeRotor kit = linear::free_rotor(scene::light_shaft_machine());
  const std::vector<double> two{0, 300};
  const std::vector<Decrement> of_kit = over_coupling(kit, 40, 200, 1, two);
  ASSERT_EQ(of_kit.size(), 2u);
  EXPECT_NEAR(of_kit[1].decrement, first_forward(kit, std::vector{40.0}, 200, 1, 300)->decrement, 1e-9);
}

/// The eigenvalue problem also knows faster whirl, whose decrement says nothing of the first one.
TEST(DampedStability, FasterWhirlThanAskedForIsNone) {
  const linear::FreeRotor disc = linear::free_rotor(scene::one_side_machine());  // 30 Hz
  EXPECT_FALSE(first_forward(disc, std::vector{10.0}, 20));
  EXPECT_TRUE(first_forward(disc, std::vector{10.0}, 31));
}

TEST(DampedStability, WhirlThatGrowsByItselfHasNoThreshold) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).rotating_damping_ratio = 0.05;
  EXPECT_EQ(threshold_n_per_m(linear::free_rotor(machine), 100, 200, 0), 0.0);
}

/// Numbers of ROSS' api_report.py.
TEST(DampedStability, TheRegionsPartAtALineOverTheDensity) {
  EXPECT_EQ(region_limit(1), 2.5);
  EXPECT_EQ(region_limit(16.53), 2.5);
  EXPECT_NEAR(region_limit(16.54), 2.5, 3e-4) << "the line begins there";
  EXPECT_NEAR(region_limit(60), 2, 1e-12);
  EXPECT_EQ(region_limit(61), 0) << "always region B";
}

}  // namespace
}  // namespace rubsweep::design
