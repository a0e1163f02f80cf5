#include "rubsweep/measurement/diagnose/known_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "light_kit.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnose {
namespace {

std::string refused(const model::RotorKit& kit) {
  try {
    known_kit({kit}, 40, "kit.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(KnownKit, HasMassFrequencyAndPlaces) {
  const KnownKit known = known_kit({light_kit()}, 40, "kit.yaml");
  EXPECT_NEAR(known.rotor_mass_kg, 0.8, 1e-6);
  // Springs of 6e4 N/m in series with the shaft's bending stiffness 48 E I / l^3.
  const double bending = 48 * 2.1e11 * std::numbers::pi * std::pow(0.01, 4) / 64 / std::pow(0.4, 3);
  const double stiffness = 1 / (1 / 6e4 + 1 / bending);
  EXPECT_NEAR(known.natural_frequency_hz, std::sqrt(stiffness / 0.8) / (2 * std::numbers::pi), 0.01);
  EXPECT_EQ(known.probe_position_m, 0.15);
  EXPECT_EQ(known.from_m, 0);
  EXPECT_EQ(known.to_m, 0.4);
  EXPECT_TRUE(known.same_all_around);
  EXPECT_EQ(place_of_stop(known, 0.123), 0.123);
}

TEST(KnownKit, UnequalSupportsTellDirectionsApart) {
  model::RotorKit kit = light_kit();
  kit.supports[0].stiffness_y_n_per_m *= 1.3;
  EXPECT_FALSE(known_kit({kit}, 40, "kit.yaml").same_all_around);
}

TEST(KnownKit, StandsInOrderOfItsFrequency) {
  const auto drawn = varied_kits(light_kit(), 0.05, 0.2, 20, 3);
  const KnownKit known = known_kit(drawn, 40, "kit.yaml");
  ASSERT_EQ(known.likely.size(), 20u);
  const auto modulus = [](const model::RotorKit& kit) { return kit.shaft[0].youngs_modulus_pa; };
  EXPECT_TRUE(std::ranges::is_sorted(known.likely, {}, modulus));
  EXPECT_EQ(modulus(likely_kit(known, 0)), modulus(known.likely.front()));
  EXPECT_EQ(modulus(likely_kit(known, 1)), modulus(known.likely.back()));
  EXPECT_EQ(modulus(likely_kit(known, 0.51)), modulus(known.likely[10]));
}

TEST(KnownKit, FactorsAreThoseOfFrequencyAndDamping) {
  model::RotorKit kit = light_kit();
  kit.supports[1].damping_x_ns_per_m = 5;
  const model::RotorKit varied = varied_kit(kit, 1.1, 2);
  const double before = known_kit({kit}, 40, "kit.yaml").natural_frequency_hz,
               after = known_kit({varied}, 40, "kit.yaml").natural_frequency_hz;
  EXPECT_NEAR(after / before, 1.1, 1e-6);
  EXPECT_NEAR(varied.damping_ratio[0], 0.04, 1e-12);
  // The damping ratio c / (2 sqrt(k m)) doubles.
  EXPECT_NEAR(varied.supports[1].damping_x_ns_per_m, 5 * 2 * 1.1, 1e-12);
}

TEST(KnownKit, HasADigestOfAllThatMovesIt) {
  const std::string digest = known_kit({light_kit()}, 40, "kit.yaml").digest;
  EXPECT_EQ(known_kit({light_kit()}, 40, "other.yaml").digest, digest);
  model::RotorKit kit = light_kit();
  kit.supports[1].damping_y_ns_per_m += 1e-3;
  EXPECT_NE(known_kit({kit}, 40, "kit.yaml").digest, digest);
  kit = light_kit();
  kit.sensors[0].position_m += 0.01;
  EXPECT_NE(known_kit({kit}, 40, "kit.yaml").digest, digest);
}

TEST(KnownKit, RefusesPartsWhoseMotionHasASizeOfItsOwn) {
  const auto with = [](auto change) {
    model::RotorKit kit = light_kit();
    change(kit);
    return refused(kit);
  };
  EXPECT_EQ(with([](model::RotorKit&) {}), "none");
  EXPECT_NE(with([](model::RotorKit& kit) {
              kit.bow = model::Bow{model::BowMode{1, 1e-5}, 0};
            }).find("kit.yaml: rotor.bow: gives the motion a size of its own"),
            std::string::npos);
  EXPECT_NE(with([](model::RotorKit& kit) {
              kit.static_loads = {{0.1, 3, 0}};
            }).find("rotor.static_loads"),
            std::string::npos);
  EXPECT_NE(with([](model::RotorKit& kit) { kit.sensors.clear(); }).find("rotor.sensors: is missing"),
            std::string::npos);
  EXPECT_NE(with([](model::RotorKit& kit) { kit.damping_ratio = {0}; }).find("rotor: has no damping"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::diagnose
