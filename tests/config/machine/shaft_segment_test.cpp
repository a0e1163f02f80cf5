#include "rubsweep/config/machine/shaft_segment.hpp"

#include "config/support.hpp"
#include "rubsweep/config/print_config.hpp"

namespace rubsweep::config::machine {
namespace {

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

TEST(ShaftSegment, ReadsEveryKey) {
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

TEST(ShaftSegment, WhatIsPrintedReadsBackTheSame) {
  const std::string printed =
      print_config(read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", {built_shaft}));
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  for (const std::string key :
       {"outer_diameter_end_m: 0.02", "layers:", "shear_coefficient: none", "gyroscopic: off"})
    EXPECT_NE(printed.find(key), std::string::npos) << key;
}

TEST(ShaftSegment, ProblemsHaveTheirPlaces) {
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
