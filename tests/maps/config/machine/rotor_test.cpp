#include "rubsweep/maps/config/machine/rotor.hpp"

#include <cmath>
#include <numbers>

#include "maps/config/support.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

const std::string by_constants =
    "rotor={kind: jeffcott, mass_kg: 2, stiffness_n_per_m: 8.0e5, damping_ns_per_m: 60}";

RunConfig read(const std::vector<std::string>& overrides) {
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml", overrides);
}
model::JeffcottRotor rotor_of(const std::vector<std::string>& overrides) {
  return std::get<model::JeffcottRotor>(read(overrides).study.machine.rotor);
}

/// Frequency: sqrt(8e5 / 2) = 632.46 rad/s = 100.66 Hz; damping ratio: 60 / (2 sqrt(8e5 2)) = 0.023717.
TEST(Rotor, ByStiffnessAndDampingConstant) {
  const model::JeffcottRotor rotor = rotor_of({by_constants});
  EXPECT_NEAR(rotor.natural_frequency_hz, std::sqrt(4e5) / (2 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(rotor.damping_ratio, 60 / (2 * std::sqrt(1.6e6)), 1e-16);
  // The matrices of the equations of motion contain the given constants.
  const auto assembly = scene::prepare_machine(read({by_constants}).study.machine).assembly;
  EXPECT_NEAR(assembly.system.stiffness(0, 0), 8e5, 1e-8);
  EXPECT_NEAR(assembly.system.damping(1, 1), 60, 1e-12);
}

TEST(Rotor, EitherConstantMayStandBesideTheOtherNumber) {
  const auto stiff =
      rotor_of({"rotor={kind: jeffcott, mass_kg: 2, stiffness_n_per_m: 8.0e5, damping_ratio: 0.03}"});
  EXPECT_EQ(stiff.damping_ratio, 0.03);
  EXPECT_NEAR(stiff.natural_frequency_hz, 100.658, 1e-3);
  const auto damped =
      rotor_of({"rotor={kind: jeffcott, mass_kg: 2, natural_frequency_hz: 50, damping_ns_per_m: 60}"});
  EXPECT_EQ(damped.natural_frequency_hz, 50);
  EXPECT_NEAR(damped.damping_ratio, 60 / (2 * 2 * 100 * std::numbers::pi), 1e-15);
}

TEST(Rotor, WhatIsPrintedReadsBackTheSame) {
  const std::string printed = print_config(read({by_constants}));
  const RunConfig again = read_run_config_text(printed, "printed.yaml", {});
  EXPECT_EQ(print_config(again), printed);
}

TEST(Rotor, AnOverrideReplacesTheOtherWayOfSayingIt) {
  EXPECT_NEAR(rotor_of({by_constants, "rotor.natural_frequency_hz=40"}).natural_frequency_hz, 40, 0);
  EXPECT_NEAR(rotor_of({"rotor.stiffness_n_per_m=8.0e5"}).natural_frequency_hz,
              std::sqrt(1e6) / (2 * std::numbers::pi), 1e-12);
  EXPECT_EQ(rotor_of({by_constants, "rotor.damping_ratio=0.01"}).damping_ratio, 0.01);
}

TEST(Rotor, ProblemsNameBothKeys) {
  const auto problem = [](const std::string& rotor) {
    return message_of(test_file("minimal.yaml"), {"rotor={kind: jeffcott, " + rotor + "}"});
  };
  EXPECT_NE(problem("mass_kg: 2, natural_frequency_hz: 30, stiffness_n_per_m: 1.0e5, damping_ratio: 0")
                .find("rotor.stiffness_n_per_m: given beside natural_frequency_hz"),
            std::string::npos)
      << problem("mass_kg: 2, natural_frequency_hz: 30, stiffness_n_per_m: 1.0e5, damping_ratio: 0");
  EXPECT_NE(problem("mass_kg: 2, stiffness_n_per_m: 0, damping_ratio: 0")
                .find("rotor.stiffness_n_per_m: 0 is out of range"),
            std::string::npos);
  EXPECT_NE(problem("mass_kg: 2, natural_frequency_hz: 30, damping_ns_per_m: -1")
                .find("rotor.damping_ns_per_m: -1 is out of range"),
            std::string::npos);
  EXPECT_NE(problem("mass_kg: 2, damping_ratio: 0").find("rotor.natural_frequency_hz: missing"),
            std::string::npos);
  EXPECT_NE(problem("mass_kg: 1.0e-30, stiffness_n_per_m: 1, damping_ns_per_m: 1.0e30")
                .find("rotor.damping_ns_per_m: gives a rotor beyond all numbers"),
            std::string::npos);
}

/// Cells with another mass would keep frequency and damping ratio instead of the constants.
TEST(Rotor, AnAxisThatWouldChangeTheConstantsIsRefused) {
  const auto problem = [](const std::string& key) {
    return message_of(test_file("minimal.yaml"),
                      {by_constants, "sweep.x={key: " + key + ", values: [1.9, 2.1]}"});
  };
  EXPECT_NE(problem("rotor.mass_kg")
                .find("rotor.mass_kg: is varied beside rotor.stiffness_n_per_m, which it would change"),
            std::string::npos)
      << problem("rotor.mass_kg");
  EXPECT_NE(problem("rotor.natural_frequency_hz").find("is varied beside rotor.damping_ns_per_m"),
            std::string::npos);
}

TEST(Rotor, AnAxisOverAConstantMakesRotorsOfThat) {
  const RunConfig config =
      read({"rotor={kind: jeffcott, mass_kg: 2, stiffness_n_per_m: 8.0e5, damping_ratio: 0.03}",
            "sweep.x={key: rotor.stiffness_n_per_m, values: [2.0e5, 8.0e5]}"});
  const sweep::KeyValue softer{"rotor.stiffness_n_per_m", 2e5};
  const auto varied = config.study.with_keys(std::span(&softer, 1)).machine;
  EXPECT_NEAR(std::get<model::JeffcottRotor>(varied.rotor).natural_frequency_hz,
              std::sqrt(1e5) / (2 * std::numbers::pi), 1e-12);
  const RunConfig damped = read({by_constants, "sweep.x={key: rotor.damping_ns_per_m, values: [30, 60]}"});
  const sweep::KeyValue less{"rotor.damping_ns_per_m", 30};
  const auto less_damped = damped.study.with_keys(std::span(&less, 1)).machine;
  EXPECT_NEAR(std::get<model::JeffcottRotor>(less_damped.rotor).damping_ratio, 30 / (2 * std::sqrt(1.6e6)),
              1e-15);
}

}  // namespace
}  // namespace rubsweep::config::machine
