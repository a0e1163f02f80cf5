#include "rubsweep/maps/config/machine/rotor_kit.hpp"

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

model::Machine read_with(const std::vector<std::string>& overrides) {
  return read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", overrides).study.machine;
}

TEST(RotorKit, ReadsEveryKey) {
  const model::Machine machine = read_with({});
  ASSERT_TRUE(model::kit_of(machine));
  const model::RotorKit& kit = *model::kit_of(machine);
  ASSERT_EQ(kit.shaft.size(), 2U);
  EXPECT_EQ(kit.shaft[0].inner_diameter_m, 0);
  EXPECT_EQ(kit.shaft[1].length_m, 0.3);
  EXPECT_EQ(kit.shaft[1].inner_diameter_m, 0.004);
  ASSERT_EQ(kit.discs.size(), 1U);
  EXPECT_EQ(kit.discs[0].eccentricity_ratio, 0.5);
  EXPECT_EQ(kit.discs[0].skew_phase_deg, 20);
  ASSERT_EQ(kit.supports.size(), 2U);
  EXPECT_EQ(kit.supports[0].stiffness_yx_n_per_m, -90);
  EXPECT_EQ(kit.supports[0].damping_yx_ns_per_m, 0.2);
  EXPECT_EQ(kit.supports[0].angular_stiffness_nm_per_rad, 7);
  EXPECT_FALSE(kit.supports[0].pedestal);
  ASSERT_TRUE(kit.supports[0].fault);
  EXPECT_EQ(kit.supports[0].fault->impulse_ns, 0.01);
  EXPECT_EQ(kit.supports[0].fault->multiple, 3.57);
  EXPECT_EQ(kit.supports[0].fault->angle_deg, 90);
  EXPECT_EQ(kit.supports[0].fault->phase_deg, 30);
  EXPECT_FALSE(kit.supports[1].fault);
  ASSERT_TRUE(kit.supports[1].pedestal);
  EXPECT_EQ(kit.supports[1].pedestal->stiffness_y_n_per_m, 1.1e5);
  EXPECT_EQ(kit.couplings.at(0).angular_stiffness_nm_per_rad, 1e3);
  EXPECT_EQ(kit.sensors.at(0).angle_deg, 45);
  ASSERT_TRUE(kit.torsion);
  EXPECT_EQ(kit.torsion->drive_damping_nms_per_rad, 0.1);
  EXPECT_EQ(kit.damping_ratio, (std::vector<double>{0.02, 0.01}));
  EXPECT_EQ(kit.modes, 4);
  EXPECT_EQ(kit.modes_up_to_hz, 900);
  EXPECT_EQ(kit.elements, 30);
  EXPECT_EQ(machine.stops.at(0).position_m, 0.3);
  EXPECT_EQ(machine.kick->position_m, 0.25);
}

TEST(RotorKit, OtherForms) {
  const model::Machine machine = read_with({"rotor.modes=auto", "rotor.damping_ratio=0.03"});
  const model::RotorKit& kit = *model::kit_of(machine);
  EXPECT_FALSE(kit.modes);
  EXPECT_EQ(kit.damping_ratio, (std::vector<double>{0.03}));
  EXPECT_EQ(kit.rotating_damping_ratio, (std::vector<double>{0}));
}

/// A pedestal does not rotate, so rotating damping is not allowed with pedestals.
TEST(RotorKit, DampingThatTurnsWithTheShaftTakesNoPedestals) {
  const std::string supports =
      "rotor.supports=[{position_m: 0, stiffness_x_n_per_m: 1e4, stiffness_y_n_per_m: 1e4}, "
      "{position_m: 0.5, stiffness_x_n_per_m: 1e4, stiffness_y_n_per_m: 1e4}]";
  const model::Machine machine = read_with({supports, "rotor.rotating_damping_ratio=[0.01, 0.002]"});
  EXPECT_EQ(model::kit_of(machine)->rotating_damping_ratio, (std::vector<double>{0.01, 0.002}));
  EXPECT_EQ(
      message_of(test_file("rotor_kit.yaml"), {"rotor.rotating_damping_ratio=0.01"}),
      "--set rotor.rotating_damping_ratio=0.01: rotor.rotating_damping_ratio: turns with the shaft, and "
      "pedestals do not, allowed: 0 beside pedestals");
  EXPECT_EQ(message_of(test_file("rotor_kit.yaml"), {"rotor.rotating_damping_ratio=0"}), "no error");
}

TEST(RotorKit, WhatIsPrintedReadsBackTheSame) {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{}, {"rotor.modes=auto", "rotor.bow={mode: 2, amplitude_m: 1e-4}"}}) {
    const RunConfig config = read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", overrides);
    const std::string printed = print_config(config);
    EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
    for (const std::string key :
         {"skew_rad_per_m: 2", "damping_yx_ns_per_m: 0.2", "pedestal:", "fault:", "multiple: 3.57",
          "position_m: 0.25", "drive_damping_nms_per_rad: 0.1", "elements: 30"}) {
      EXPECT_NE(printed.find(key), std::string::npos) << key;
    }
  }
}

TEST(RotorKit, ASupportMayHaveAName) {
  for (const std::string name : {"Drive end", "a: \"b\", c"}) {
    const RunConfig config = read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml",
                                                  {"rotor.supports.0.name='" + name + "'"});
    EXPECT_EQ(model::kit_of(config.study.machine)->supports[0].name, name);
    const RunConfig again = read_run_config_text(print_config(config), "printed.yaml", {});
    EXPECT_EQ(model::kit_of(again.study.machine)->supports[0].name, name);
  }
}

TEST(RotorKit, DiscsAndSensorsMayHaveNames) {
  const RunConfig config =
      read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml",
                           {"rotor.discs.0.name=Coupling hub", "rotor.sensors.0.name=DE x",
                            "rotor.point_masses=[{position_m: 0.1, mass_kg: 0.2, name: Nut}]"});
  const RunConfig again = read_run_config_text(print_config(config), "printed.yaml", {});
  for (const RunConfig* one : {&config, &again}) {
    const model::RotorKit& kit = *model::kit_of(one->study.machine);
    EXPECT_EQ(kit.discs.at(0).name, "Coupling hub");
    EXPECT_EQ(kit.sensors.at(0).name, "DE x");
    EXPECT_EQ(kit.point_masses.at(0).name, "Nut");
    EXPECT_FALSE(kit.from_file);
  }
}

TEST(RotorKit, ProblemsHaveTheirPlaces) {
  const auto message = [](const std::string& override) {
    return message_of(test_file("rotor_kit.yaml"), {override}, "kit.yaml");
  };
  EXPECT_NE(message("rotor.discs.0.position_m=0.6")
                .find("rotor.discs.0.position_m: 0.6 is out of range, allowed: a number >= 0 and <= 0.5"),
            std::string::npos);
  EXPECT_NE(message("stops.0.position_m=0.6").find("stops.0.position_m: 0.6 is out of range"),
            std::string::npos);
  EXPECT_NE(message("kick.position_m=-1").find("kick.position_m: -1 is out of range"), std::string::npos);
  EXPECT_NE(
      message("rotor.shaft.1.inner_diameter_m=0.02").find("rotor.shaft.1.inner_diameter_m: no wall is left"),
      std::string::npos);
  EXPECT_NE(message("rotor.supports.0.fault={impulse_ns: 1}")
                .find("rotor.supports.0.fault.multiple: missing, allowed: a number > 0 and <= 1000"),
            std::string::npos);
  EXPECT_NE(message("rotor.supports.0.fault.phase_deg=360")
                .find("rotor.supports.0.fault.phase_deg: 360 is out of range"),
            std::string::npos);
  EXPECT_NE(message("rotor.supports.0.fault.impuls_ns=1").find("unknown key (did you mean 'impulse_ns'?)"),
            std::string::npos);
  EXPECT_NE(message("rotor.modes=all").find("rotor.modes: 'all' is not an integer"), std::string::npos);
  EXPECT_NE(message("rotor.discs.0.mas_kg=1").find("unknown key (did you mean 'mass_kg'?)"),
            std::string::npos);
  EXPECT_NE(
      message("rotor.supports=[{position_m: 0.1, stiffness_x_n_per_m: 1, stiffness_y_n_per_m: 1}]")
          .find("rotor.supports: leaves the shaft free to move in x, allowed: supports that hold the shaft"),
      std::string::npos);
  EXPECT_NE(message("rotor.mass_kg=1").find("rotor.mass_kg: unknown key"), std::string::npos);
}

TEST(RotorKit, NumbersThatNoMachineHasAreRefusedInTheirPlace) {
  for (const std::string override :
       {"rotor.shaft.0.outer_diameter_m=1e-300", "rotor.shaft.0.outer_diameter_m=1e100",
        "rotor.shaft.1.length_m=1e-9", "rotor.shaft.0.youngs_modulus_pa=1e200",
        "rotor.shaft.0.density_kg_per_m3=1e-200", "rotor.discs.0.mass_kg=1e50",
        "rotor.supports.0.stiffness_x_n_per_m=1e30", "rotor.supports.1.pedestal.mass_kg=1e-100",
        "rotor.couplings.0.lateral_stiffness_n_per_m=1e-50", "rotor.torsion.drive_stiffness_nm_per_rad=1e99",
        "rotor.couplings.0.position_m=0", "rotor.couplings.0.position_m=0.5", "rotor.modes_up_to_hz=1e300",
        "rotor.bow.deflection_m=[0, 1e99, 0]"}) {
    const std::string text = message_of(test_file("rotor_kit.yaml"), {override}, "kit.yaml");
    EXPECT_NE(text.find("out of range, allowed: a number >= "), std::string::npos) << override << "\n"
                                                                                   << text;
    EXPECT_TRUE(text.starts_with("--set " + override)) << text;
  }
  EXPECT_NE(message_of(test_file("rotor_kit.yaml"), {"rotor.discs.0.polar_inertia_kg_m2=7e-4"}, "kit.yaml")
                .find("is more than twice the diametral one, which no body has, allowed: at most 0.00064"),
            std::string::npos);
}

TEST(RotorKit, AnAsymmetricCouplingStandsBesideNoTorsion) {
  const std::string file = test_file("rotor_kit.yaml");
  for (const std::string key : {"lateral_asymmetry_ratio", "angular_asymmetry_ratio"}) {
    const std::string place = "rotor.couplings.0." + key + "=";
    EXPECT_NE(
        message_of(file, {place + "0.1"}, "kit.yaml")
            .find("rotor.torsion: is given beside a coupling with an asymmetry ratio, whose force does not "
                  "know the angle of torsion, allowed: couplings that are equally stiff all around"),
        std::string::npos);
    EXPECT_NE(message_of(file, {place + "0.4"}, "kit.yaml")
                  .find("is out of range, allowed: a number >= 0 and <= 0.3"),
              std::string::npos);
    EXPECT_NE(message_of(file, {place + "-0.1"}, "kit.yaml").find("is out of range"), std::string::npos);
  }
  auto machine = read_run_config_text(file, "kit.yaml", {}).study.machine;
  model::kit_of(machine)->couplings[0].lateral_asymmetry_ratio = 0.1;
  EXPECT_THROW(model::validate(*model::kit_of(machine), "rotor."), ConfigError);
}

TEST(RotorKit, AJeffcottRotorHasNoPlaces) {
  EXPECT_NE(message_of(test_file("minimal.yaml"), {"stops.0.position_m=0.1"})
                .find("stops.0.position_m: unknown key"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::machine
