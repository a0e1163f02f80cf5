#include <variant>

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

const std::string supports =
    "rotor.supports=[{position_m: 0, on_housing: 0, stiffness_x_n_per_m: 1e5, stiffness_y_n_per_m: 1e5}, "
    "{at_housing: 0, on_housing: 1, stiffness_x_n_per_m: 2e5, stiffness_y_n_per_m: 2e5}, "
    "{at_housing: 1, stiffness_x_n_per_m: 3e5, stiffness_y_n_per_m: 3e5}, "
    "{position_m: 0.5, stiffness_x_n_per_m: 1e5, stiffness_y_n_per_m: 1e5, fault: {impulse_ns: 0.01, "
    "bearing: "
    "{defect: outer_race, pitch_diameter_m: 0.04, ball_diameter_m: 0.01, balls: 8}}}]";
const std::vector<std::string> built{"rotor.housings=[{mass_kg: 2}, {mass_kg: 3, mass_y_kg: 4}]",
                                     supports,
                                     "rotor.point_masses=[{position_m: 0.1, mass_kg: 0.2, mass_y_kg: 0.3}]",
                                     "rotor.static_loads=[{position_m: 0.3, force_x_n: 4, force_y_n: -5}]",
                                     "rotor.clearances_from=sag",
                                     "rotor.couplings.0.parallel_offset_m=1e-5",
                                     "rotor.couplings.0.angular_offset_rad=1e-3",
                                     "rotor.couplings.0.parallel_misalignment_m=2e-4",
                                     "rotor.couplings.0.angular_misalignment_angle_deg=30",
                                     "rotor.discs=[{position_m: 0.25, geometry: {outer_diameter_m: 0.1, "
                                     "width_m: 0.01, density_kg_per_m3: 7850}}]"};

TEST(RotorParts, ReadEveryKey) {
  const auto machine = read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", built).study.machine;
  const model::RotorKit& kit = *model::kit_of(machine);
  ASSERT_EQ(kit.housings.size(), 2U);
  EXPECT_EQ(kit.housings[1].mass_y_kg, 4);
  ASSERT_EQ(kit.supports.size(), 4U);
  EXPECT_EQ(kit.supports[0].on_housing, 0);
  EXPECT_EQ(kit.supports[1].at_housing, 0);
  EXPECT_EQ(kit.supports[1].on_housing, 1);
  EXPECT_FALSE(kit.supports[2].on_housing);
  EXPECT_DOUBLE_EQ(kit.supports[3].fault->multiple, 3);
  EXPECT_EQ(kit.point_masses.at(0).mass_y_kg, 0.3);
  EXPECT_EQ(kit.static_loads.at(0).force_y_n, -5);
  EXPECT_TRUE(kit.clearances_from_sag);
  EXPECT_EQ(kit.couplings.at(0).parallel_offset_m, 1e-5);
  EXPECT_EQ(kit.couplings.at(0).parallel_misalignment_m, 2e-4);
  EXPECT_EQ(kit.couplings.at(0).angular_misalignment_angle_deg, 30);
  EXPECT_NO_THROW(model::validate(kit, "rotor."));
  EXPECT_NEAR(kit.discs.at(0).mass_kg, 7850 * 3.14159265358979323846 / 4 * 0.01 * 0.01, 1e-14);
}

TEST(RotorParts, WhatIsPrintedReadsBackTheSame) {
  const std::string printed =
      print_config(read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", built));
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  for (const std::string key :
       {"at_housing: 1", "on_housing: 0", "clearances_from: sag", "multiple: 3", "housings:"})
    EXPECT_NE(printed.find(key), std::string::npos) << key;
}

TEST(RotorParts, ProblemsOfHousingsHaveTheirPlaces) {
  EXPECT_NE(kit_message({supports}).find("rotor.supports.0.on_housing: there are no housings"),
            std::string::npos);
  EXPECT_NE(kit_message({"rotor.housings=[{mass_kg: 2}]", supports})
                .find("rotor.supports.1.on_housing: 1 is out of range, allowed: an integer from 0 to 0"),
            std::string::npos);
  EXPECT_NE(kit_message({"rotor.housings=[{mass_kg: 2}, {mass_kg: 3}, {mass_kg: 1}]", supports})
                .find("rotor.supports: leaves the shaft or a housing free to move in x"),
            std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.housings=[{mass_kg: 2}]", "rotor.supports.0.at_housing=0"}).find("given beside"),
      std::string::npos);
  EXPECT_NE(kit_message({"rotor.housings=[{mass_kg: 2}]", "rotor.supports.1.on_housing=0"})
                .find("rotor.supports.1.on_housing: given beside a pedestal, allowed: one of the two"),
            std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.housings=[{mass_kg: 0}]"}).find("rotor.housings.0.mass_kg: 0 is out of range"),
      std::string::npos);
}

TEST(RotorParts, ProblemsOfGeometryHaveTheirPlaces) {
  EXPECT_NE(
      kit_message(
          {"rotor.discs=[{position_m: 0.25, mass_kg: 1, geometry: {outer_diameter_m: 0.1, width_m: 0.01, "
           "density_kg_per_m3: 1}}]"})
          .find("given beside"),
      std::string::npos);
  // A matrix that is written over the numbers of a file replaces these numbers.
  EXPECT_EQ(
      kit_message({"rotor.discs.0.geometry={outer_diameter_m: 0.1, width_m: 0.01, density_kg_per_m3: 1}"})
          .find("given beside"),
      std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.discs=[{position_m: 0.25, geometry: {outer_diameter_m: 0.1, inner_diameter_m: 0.1, "
                   "width_m: 0.01, density_kg_per_m3: 1}}]"})
          .find("rotor.discs.0.geometry.inner_diameter_m: no disc is left, allowed: a number below "
                "outer_diameter_m"),
      std::string::npos);
  EXPECT_NE(kit_message({"rotor.discs=[{position_m: 0.25, geometry: {outer_diameter_m: 0.1}}]"})
                .find("rotor.discs.0.geometry.width_m: missing"),
            std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.supports.0.fault={impulse_ns: 1, bearing: {defect: race, pitch_diameter_m: 0.04, "
                   "ball_diameter_m: 0.05, balls: 8}}"})
          .find("rotor.supports.0.fault.bearing.defect: 'race' is unknown"),
      std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.supports.0.fault={impulse_ns: 1, bearing: {defect: ball, pitch_diameter_m: 0.04, "
                   "ball_diameter_m: 0.05, balls: 8}}"})
          .find("ball_diameter_m: leaves no room for a shaft"),
      std::string::npos);
  EXPECT_NE(kit_message({"rotor.supports.0.fault={impulse_ns: 1, multiple: 3, bearing: {defect: ball, "
                         "pitch_diameter_m: 0.04, "
                         "ball_diameter_m: 0.01, balls: 8}}"})
                .find("given beside"),
            std::string::npos);
}

TEST(RotorParts, LoadsThatAreNoNumbersAreRefused) {
  EXPECT_NE(kit_message({"rotor.static_loads=[{position_m: 0.3, force_x_n: .inf}]"}).find("is not finite"),
            std::string::npos);
  EXPECT_NE(kit_message({"rotor.static_loads=[{position_m: 0.6, force_x_n: 1}]"})
                .find("rotor.static_loads.0.position_m: 0.6 is out of range"),
            std::string::npos);
  EXPECT_NE(kit_message({"rotor.clearances_from=centre"}).find("'centre' is unknown, allowed: axis, sag"),
            std::string::npos);
}

model::Bow bow_with(const std::vector<std::string>& overrides) {
  const model::Machine machine =
      read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", overrides).study.machine;
  return model::kit_of(machine)->bow.value();
}

TEST(RotorParts, BowIsALineThroughPoints) {
  const model::Bow bow = bow_with({});
  EXPECT_EQ(std::get<model::BowPoints>(bow.shape).deflection_m, (std::vector<double>{0, 1e-5, 0}));
  EXPECT_EQ(bow.phase_deg, 30);
}

TEST(RotorParts, BowIsAModeInsteadOfALine) {
  const model::Bow bow = bow_with({"rotor.bow={mode: 2, amplitude_m: 1e-4}"});
  EXPECT_EQ(std::get<model::BowMode>(bow.shape).mode, 2);
  EXPECT_EQ(std::get<model::BowMode>(bow.shape).amplitude_m, 1e-4);
}

TEST(RotorParts, ProblemsOfBowsHaveTheirPlaces) {
  EXPECT_NE(kit_message({"rotor.bow={mode: 1}"}).find("rotor.bow.amplitude_m: missing"), std::string::npos);
  EXPECT_NE(kit_message({"rotor.bow={phase_deg: 1}"})
                .find("rotor.bow: one key is missing, allowed: exactly one of mode, position_m"),
            std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.bow.position_m=[0, 0.1, 2]"}).find("rotor.bow.position_m.2: 2 is out of range"),
      std::string::npos);
}

constexpr const char* built_shaft =
    "rotor.shaft=[{length_m: 0.2, outer_diameter_m: 0.01, outer_diameter_end_m: 0.02, inner_diameter_end_m: "
    "0.001, "
    "youngs_modulus_pa: 2.06e11, shear_modulus_pa: 7.9e10, density_kg_per_m3: 7850, shear_coefficient: "
    "hutchinson, "
    "rotary_inertia: off, gyroscopic: off, mass_damping_per_s: 2, stiffness_damping_s: 1e-6}, "
    "{length_m: 0.3, outer_diameter_m: 0.02, stiffness_outer_diameter_m: 0.015, stiffness_inner_diameter_m: "
    "0.003, "
    "youngs_modulus_pa: 2.06e11, shear_modulus_pa: 7.9e10, density_kg_per_m3: 7850, layers: "
    "[{outer_diameter_m: 0.03, "
    "inner_diameter_m: 0.02, youngs_modulus_pa: 1e6, shear_modulus_pa: 1e6, density_kg_per_m3: 1000, "
    "shear_coefficient: none}]}]";

TEST(RotorParts, ReadsEveryKeyOfASegment) {
  const auto machine =
      read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", {built_shaft}).study.machine;
  const model::RotorKit& kit = *model::kit_of(machine);
  ASSERT_EQ(kit.shaft.size(), 2U);
  EXPECT_EQ(kit.shaft[0].outer_diameter_end_m, 0.02);
  EXPECT_EQ(kit.shaft[0].inner_diameter_end_m, 0.001);
  EXPECT_EQ(kit.shaft[0].shear_coefficient, model::ShearCoefficient::hutchinson);
  EXPECT_FALSE(kit.shaft[0].rotary_inertia);
  EXPECT_FALSE(kit.shaft[0].gyroscopic);
  EXPECT_EQ(kit.shaft[0].mass_damping_per_s, 2);
  EXPECT_EQ(kit.shaft[0].stiffness_damping_s, 1e-6);
  EXPECT_EQ(kit.shaft[1].stiffness_outer_diameter_m, 0.015);
  EXPECT_EQ(kit.shaft[1].stiffness_inner_diameter_m, 0.003);
  EXPECT_EQ(kit.shaft[1].shear_coefficient, model::ShearCoefficient::cowper);
  EXPECT_TRUE(kit.shaft[1].gyroscopic);
  ASSERT_EQ(kit.shaft[1].layers.size(), 1U);
  EXPECT_EQ(kit.shaft[1].layers[0].inner_diameter_m, 0.02);
  EXPECT_EQ(kit.shaft[1].layers[0].shear_coefficient, model::ShearCoefficient::none);
}

TEST(RotorParts, WhatIsPrintedOfASegmentReadsBackTheSame) {
  const std::string printed =
      print_config(read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", {built_shaft}));
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  for (const std::string key :
       {"outer_diameter_end_m: 0.02", "layers:", "shear_coefficient: none", "gyroscopic: off"})
    EXPECT_NE(printed.find(key), std::string::npos) << key;
}

TEST(RotorParts, ProblemsOfSegmentsHaveTheirPlaces) {
  const auto message = [](const std::string& override) {
    return message_of(test_file("rotor_kit.yaml"), {override}, "kit.yaml");
  };
  EXPECT_NE(message("rotor.shaft.0.inner_diameter_end_m=0.02")
                .find("rotor.shaft.0.inner_diameter_end_m: no wall is left, allowed: an inner diameter below "
                      "the outer "
                      "one at the end of the segment, too"),
            std::string::npos);
  EXPECT_NE(
      message("rotor.shaft.0.shear_coefficient=timoshenko")
          .find(
              "rotor.shaft.0.shear_coefficient: 'timoshenko' is unknown, allowed: cowper, hutchinson, none"),
      std::string::npos);
  EXPECT_NE(message("rotor.shaft.0.layers=[{outer_diameter_m: 0.02, density: 3}]")
                .find("rotor.shaft.0.layers.0.density: unknown key (did you mean 'density_kg_per_m3'?)"),
            std::string::npos);
  EXPECT_NE(
      message(
          "rotor.shaft.0.layers=[{outer_diameter_m: 0.02, inner_diameter_m: 0.03, youngs_modulus_pa: 1e9, "
          "shear_modulus_pa: 1e9, density_kg_per_m3: 1}]")
          .find("rotor.shaft.0.layers.0.inner_diameter_m: no wall is left"),
      std::string::npos);
  EXPECT_NE(message("rotor.shaft.0.stiffness_damping_s=-1")
                .find("rotor.shaft.0.stiffness_damping_s: -1 is out of range"),
            std::string::npos);
  EXPECT_NE(message("rotor.shaft.0.mass_damping_per_s=.nan")
                .find("rotor.shaft.0.mass_damping_per_s: '.nan' is not finite"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::machine
