#include "rubsweep/config/machine/rotor_parts.hpp"

#include "config/support.hpp"
#include "rubsweep/config/print_config.hpp"

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
  EXPECT_NE(
      kit_message(
          {"rotor.supports.0.fault.bearing={defect: ball, pitch_diameter_m: 0.04, ball_diameter_m: 0.01, "
           "balls: 8}"})
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

}  // namespace
}  // namespace rubsweep::config::machine
