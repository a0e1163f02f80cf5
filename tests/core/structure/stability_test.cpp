#include "rubsweep/core/structure/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"

namespace rubsweep::structure {
namespace {

using std::numbers::pi;

Assembly damped_jeffcott(double stationary, double rotating) {
  return assemble_jeffcott({.mass_kg = 0.8,
                            .natural_frequency_hz = 30,
                            .damping_ratio = stationary,
                            .rotating_damping_ratio = rotating},
                           {model::Casing{.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 0.1}});
}

/// m z'' + c z' + c_r (z' - i w z) + k z = 0 has a forward whirl at w_n = sqrt(k/m) that neither grows nor
/// decays where c w_n = c_r (w - w_n).
TEST(StabilityInstabilityHz, OfAJeffcottRotorIsTheClosedForm) {
  for (const auto& [stationary, rotating] : {std::pair{0.02, 0.01}, {0.01, 0.04}, {0.05, 0.05}}) {
    const auto found = instability_hz(damped_jeffcott(stationary, rotating), 400);
    ASSERT_TRUE(found);
    const double expected = 30 * (1 + stationary / rotating);
    EXPECT_NEAR(*found, expected, 1e-5 * expected) << stationary << " " << rotating;
  }
  EXPECT_NEAR(instability_hz(damped_jeffcott(0, 0.01), 400).value(), 30, 1e-3);
  EXPECT_FALSE(instability_hz(damped_jeffcott(0.02, 0), 400));
  EXPECT_FALSE(instability_hz(damped_jeffcott(0.1, 0.005), 600)) << "630 Hz";
}

/// Roots of s^2 + 2 (z + zr) s + 1 - 2 i zr w = 0, in units of the natural frequency.
TEST(StabilityGrowthPerS, IsTheRootOfTheComplexEquation) {
  const double stationary = 0.02, rotating = 0.03, natural = 60 * pi;
  for (const double speed : {0.0, 0.7, 1.6, 1.7, 5.0}) {
    const std::complex<double> half = stationary + rotating;
    const auto root = std::sqrt(half * half - 1.0 + std::complex<double>(0, 2 * rotating * speed));
    const double growth = natural * std::max((-half + root).real(), (-half - root).real());
    EXPECT_NEAR(growth_per_s(damped_jeffcott(stationary, rotating), speed * natural), growth, 1e-9 * natural);
  }
}

/// A slender shaft in nearly rigid bearings, with equal damping ratios for all modes. Its first mode is a
/// Jeffcott rotor, apart from the small rotary inertia of the central discs and the thin shaft.
TEST(StabilityInstabilityHz, OfARotorKitIsThatOfItsFirstMode) {
  model::RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = 0.01,
                 .youngs_modulus_pa = 2.06e11,
                 .shear_modulus_pa = 7.92e10,
                 .density_kg_per_m3 = 7850},
                0.46}};
  kit.discs = {
      {.position_m = 0.23, .mass_kg = 0.8, .polar_inertia_kg_m2 = 5.6e-4, .diametral_inertia_kg_m2 = 3.2e-4}};
  for (const double position_m : {0.0, 0.46}) {
    model::Support& support = kit.supports.emplace_back();
    support.position_m = position_m;
    support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 1e9;
  }
  kit.damping_ratio = {0.02};
  kit.rotating_damping_ratio = {0.01};
  kit.modes = 3;
  model::Stop stop;
  stop.geometry = model::OneSideGeometry{90};
  stop.position_m = 0.29;
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 1e7;
  stop.contact_radius_m = 5e-3;
  stop.damping = model::ExplicitDamping{0};
  model::Machine machine{.rotor = kit, .stops = {stop}, .kick = {}};
  const KitAssembly assembled = assemble_rotor_kit(machine);
  const double first_hz = assembled.reduction.frequency_hz[0](0);
  EXPECT_NEAR(instability_hz(assembled.assembly, 10 * first_hz).value(), 3 * first_hz, 2e-3 * first_hz);
  const auto& circulatory = assembled.assembly.circulatory;
  EXPECT_EQ(circulatory, -circulatory.transpose());
  std::get<model::RotorKit>(machine.rotor).rotating_damping_ratio = {0};
  EXPECT_EQ(assemble_rotor_kit(machine).assembly.circulatory.size(), 0);
}

/// A conservative kit whose planes are coupled by equal cross stiffnesses: rounding must not count as growth.
/// The smallest circulatory force exceeds rounding.
TEST(StabilityGrows, AboveRoundingAlone) {
  model::RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = 0.03,
                 .youngs_modulus_pa = 2.06e11,
                 .shear_modulus_pa = 7.92e10,
                 .density_kg_per_m3 = 7850},
                0.5}};
  kit.discs = {
      {.position_m = 0.1, .mass_kg = 2, .polar_inertia_kg_m2 = 4e-3, .diametral_inertia_kg_m2 = 2e-3}};
  for (const double position_m : {0.05, 0.45}) {
    model::Support support;
    support.position_m = position_m;
    support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 3e7;
    support.stiffness_xy_n_per_m = support.stiffness_yx_n_per_m = -5e6;
    kit.supports.push_back(support);
  }
  model::Stop stop;
  stop.geometry = model::OneSideGeometry{90};
  stop.position_m = 0.1;
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 1e7;
  stop.contact_radius_m = 5e-3;
  stop.damping = model::ExplicitDamping{0};
  model::Machine machine{.rotor = kit, .stops = {stop}, .kick = {}};
  const Assembly conservative = assemble_rotor_kit(machine).assembly;
  for (const double hz : {0.0, 50.0, 400.0, 2000.0}) {
    EXPECT_FALSE(grows(conservative, 2 * pi * hz)) << hz;
    EXPECT_EQ(growth_per_s(conservative, 2 * pi * hz), 0) << hz;
  }
  auto& supports = model::kit_of(machine)->supports;
  supports[0].stiffness_xy_n_per_m += 100;
  supports[0].stiffness_yx_n_per_m -= 100;
  EXPECT_TRUE(grows(assemble_rotor_kit(machine).assembly, 2 * pi * 50));
}

}  // namespace
}  // namespace rubsweep::structure
