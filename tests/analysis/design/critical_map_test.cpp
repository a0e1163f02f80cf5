#include "rubsweep/analysis/design/critical_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace rubsweep::design {
namespace {

using std::numbers::pi;

constexpr double length_m = 1, diameter_m = 0.04, density = 7800, youngs_pa = 2.1e11;
const double mass_kg = density * pi / 4 * diameter_m * diameter_m * length_m;
/// Frequency in Hz of a mode of a thin beam by its wave number times its length.
double beam_hz(double wave_number) {
  const double bending = youngs_pa * pi / 64 * std::pow(diameter_m, 4);
  return wave_number * wave_number / (2 * pi) * std::sqrt(bending / (mass_kg * std::pow(length_m, 3)));
}

model::Support bearing_at(double position_m) {
  model::Support support;
  support.position_m = position_m;
  support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 1e6;
  support.damping_x_ns_per_m = 1e3;
  support.stiffness_xy_n_per_m = 1e5;
  support.mass_x_kg = 3;
  return support;
}

/// Thin shaft without rotary inertia and shear on bearings at both ends.
model::RotorKit thin_shaft() {
  model::RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = diameter_m,
                 .youngs_modulus_pa = youngs_pa,
                 .shear_modulus_pa = 8.1e10,
                 .density_kg_per_m3 = density,
                 .shear_coefficient = model::ShearCoefficient::none,
                 .rotary_inertia = false,
                 .gyroscopic = false},
                length_m}};
  kit.supports = {bearing_at(0), bearing_at(length_m)};
  kit.elements = 60;
  return kit;
}

TEST(CriticalMap, OnRigidBearingsABeamIsPinned) {
  const auto map = critical_map(thin_shaft(), {}, std::vector{1e12}, 3);
  ASSERT_EQ(map.size(), 1u);
  ASSERT_EQ(map[0].speed_hz.size(), 3u);
  for (int mode = 1; mode <= 3; ++mode)
    EXPECT_NEAR(map[0].speed_hz[static_cast<std::size_t>(mode - 1)] / beam_hz(mode * pi), 1, 1e-5) << mode;
}

TEST(CriticalMap, RigidBearingsPinTheBeamOfAMachine) {
  model::Machine machine;
  machine.rotor = thin_shaft();
  EXPECT_NEAR(rigid_critical_hz(machine).value() / beam_hz(pi), 1, 1e-5);
  model::kit_of(machine)->supports.clear();
  EXPECT_FALSE(rigid_critical_hz(machine));
  machine.rotor = model::JeffcottRotor{.mass_kg = 2, .natural_frequency_hz = 40, .damping_ratio = 0.1};
  EXPECT_EQ(rigid_critical_hz(machine), 40);
}

TEST(CriticalMap, OnSoftBearingsABeamIsFreeAndSwingsAsABody) {
  const double stiffness = 1;
  const auto map = critical_map(thin_shaft(), {}, std::vector{stiffness}, 4);
  ASSERT_EQ(map[0].speed_hz.size(), 4u);
  EXPECT_NEAR(map[0].speed_hz[0] / (std::sqrt(2 * stiffness / mass_kg) / (2 * pi)), 1, 1e-4);
  EXPECT_NEAR(map[0].speed_hz[1] / (std::sqrt(6 * stiffness / mass_kg) / (2 * pi)), 1, 1e-4);
  EXPECT_NEAR(map[0].speed_hz[2] / beam_hz(4.730040744862704), 1, 1e-5);
  EXPECT_NEAR(map[0].speed_hz[3] / beam_hz(7.853204624095838), 1, 1e-5);
}

/// A disc in the middle of a stiff light shaft: k L^2 / 2 = w^2 (diametral - polar inertia).
TEST(CriticalMap, GyroscopicMomentsRaiseTheConicalWhirlOrDriveItAway) {
  model::RotorKit kit = thin_shaft();
  kit.shaft.front().density_kg_per_m3 = 1e-4;
  kit.shaft.front().outer_diameter_m = 0.3;
  kit.discs = {
      {.position_m = 0.5, .mass_kg = 10, .polar_inertia_kg_m2 = 0.3, .diametral_inertia_kg_m2 = 0.8}};
  const double stiffness = 2e5;
  const auto slender = critical_map(kit, {}, std::vector{stiffness}, 2);
  ASSERT_EQ(slender[0].speed_hz.size(), 2u);
  EXPECT_NEAR(slender[0].speed_hz[0] * 2 * pi / std::sqrt(2 * stiffness / 10), 1, 1e-3);
  EXPECT_NEAR(slender[0].speed_hz[1] * 2 * pi / std::sqrt(stiffness / 2 / 0.5), 1, 1e-3);
  kit.discs.front().polar_inertia_kg_m2 = 1.6;
  const auto flat = critical_map(kit, {}, std::vector{stiffness}, 2);
  EXPECT_NEAR(flat[0].speed_hz[0], slender[0].speed_hz[0], 1e-6);
  EXPECT_TRUE(flat[0].speed_hz.size() < 2 || flat[0].speed_hz[1] > 20 * slender[0].speed_hz[1]);
}

TEST(CriticalMap, LeavesOutSealsAndNeedsABearing) {
  model::RotorKit kit = thin_shaft();
  const std::vector stiffness{1e5, 1e7};
  const auto bare = critical_map(kit, {0.4}, stiffness, 2);
  model::Support seal = bearing_at(0.4);
  seal.name = "SealElement_A";
  kit.supports.push_back(seal);
  const auto sealed = critical_map(kit, {0.4}, stiffness, 2);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(sealed[i].speed_hz[k], bare[i].speed_hz[k], 1e-9 * bare[i].speed_hz[k]);
  kit.supports = {seal};
  EXPECT_TRUE(critical_map(kit, {}, stiffness, 2).empty());
}

}  // namespace
}  // namespace rubsweep::design
