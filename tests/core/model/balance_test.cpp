#include "rubsweep/core/model/balance.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rubsweep::model {
namespace {

using std::numbers::pi;

Machine jeffcott() {
  return {.rotor = JeffcottRotor{.mass_kg = 2.5, .natural_frequency_hz = 40, .damping_ratio = 0.02},
          .stops = {},
          .kick = {}};
}

/// Two discs with opposite eccentricities on a hollow shaft of 1.5 kg.
Machine kit() {
  RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = 0.03,
                 .inner_diameter_m = 0.01,
                 .youngs_modulus_pa = 2e11,
                 .shear_modulus_pa = 8e10,
                 .density_kg_per_m3 = 1.5 / (0.5 * pi / 4 * (0.03 * 0.03 - 0.01 * 0.01))},
                0.5}};
  const auto disc = [](double mass_kg, double ratio, double phase_deg) {
    return Disc{.position_m = 0.2,
                .mass_kg = mass_kg,
                .polar_inertia_kg_m2 = 1e-3,
                .diametral_inertia_kg_m2 = 1e-3,
                .eccentricity_ratio = ratio,
                .eccentricity_phase_deg = phase_deg};
  };
  kit.discs = {disc(2, 1, 0), disc(1, -0.5, 0), disc(0.5, 0, 90)};
  return {.rotor = kit, .stops = {}, .kick = {}};
}

TEST(Balance, TakesTheEccentricityOfAJeffcottRotorFromItsMass) {
  // 500 g mm on a rotor of 2.5 kg give an eccentricity of exactly 0.2 mm.
  EXPECT_EQ(500 / g_mm_per_metre(jeffcott()), 2e-4);
}

TEST(Balance, TakesAGradeAtItsRatedSpeed) {
  // ISO 21940-11: G 6.3 at 3000 rpm permits an eccentricity of 20 micrometres, whatever the mass is.
  EXPECT_NEAR(6.3 / grade_per_metre(jeffcott(), 50), 20.05e-6, 0.005e-6);
  EXPECT_DOUBLE_EQ(grade_per_metre(jeffcott(), 100), 2 * grade_per_metre(jeffcott(), 50));
}

TEST(Balance, CountsTheUnbalanceOfAKitByItsDiscs) {
  EXPECT_DOUBLE_EQ(unbalanced_mass_kg(kit()), 2.5);
  EXPECT_DOUBLE_EQ(g_mm_per_metre(kit()), 2.5e6);
}

TEST(Balance, PermitsAKitTheUnbalanceOfItsWholeMass) {
  EXPECT_NEAR(rotor_mass_kg(kit()), 5, 1e-12);
  // The permitted unbalance G m / w equals the discs' unbalance at the eccentricity given by the grade.
  const double w = 2 * pi * 50, eccentricity_m = 6.3 / grade_per_metre(kit(), 50);
  EXPECT_NEAR(eccentricity_m * unbalanced_mass_kg(kit()), 6.3e-3 * rotor_mass_kg(kit()) / w, 1e-15);
}

}  // namespace
}  // namespace rubsweep::model
