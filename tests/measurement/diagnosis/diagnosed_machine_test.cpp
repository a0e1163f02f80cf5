#include "rubsweep/measurement/diagnosis/diagnosed_machine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "measurement/diagnosis/machine_file.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnosis {
namespace {

std::string refused(const MachineFile& file) {
  try {
    read_diagnosed_machine(file.path, 1);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(DiagnosedMachine, WithoutAFitNumbersAreKnownToAShareOfTheirValues) {
  const MachineFile file;
  const DiagnosedMachine machine = read_diagnosed_machine(file.path, 1);
  EXPECT_NEAR(machine.natural_frequency_hz.low, 30 / 1.01, 1e-12);
  EXPECT_NEAR(machine.natural_frequency_hz.high, 30 * 1.01, 1e-12);
  EXPECT_NEAR(machine.damping_ratio.low, 0.02 / 1.2, 1e-15);
  EXPECT_EQ(machine.fixed.rotor_mass_kg, 0.8);
  EXPECT_FALSE(machine.eccentricity_m);
  EXPECT_TRUE(machine.kits.empty());
  EXPECT_EQ(machine.remarks.size(), 3u);
}

TEST(DiagnosedMachine, TheIntervalOfAFitIsTaken) {
  const MachineFile file;
  file.write_fit("rotor.damping_ratio", 0.02, 0.018, 0.023);
  const DiagnosedMachine machine = read_diagnosed_machine(file.path, 1);
  EXPECT_EQ(machine.damping_ratio.low, 0.018);
  EXPECT_EQ(machine.damping_ratio.high, 0.023);
}

constexpr std::string_view with_interval =
    "{kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: {value: 0.02, from: 0.01, to: "
    "0.04}}";

TEST(DiagnosedMachine, AnIntervalOfTheConfigurationIsTaken) {
  const MachineFile file(with_interval);
  const DiagnosedMachine machine = read_diagnosed_machine(file.path, 1);
  EXPECT_EQ(machine.damping_ratio.low, 0.01);
  EXPECT_EQ(machine.damping_ratio.high, 0.04);
  EXPECT_NEAR(machine.natural_frequency_hz.high, 30 * 1.01, 1e-12);
  file.write_fit("rotor.natural_frequency_hz", 30, 29, 31);
  EXPECT_NE(refused(file).find("rotor.damping_ratio: has an interval beside parameters.csv of a fit"),
            std::string::npos);
}

TEST(DiagnosedMachine, KitsAreDrawnFromTheIntervalOfAKey) {
  std::string wide(kit);
  wide.replace(wide.find("mass_kg: 0.8"), 12, "mass_kg: {value: 0.8, from: 0.6, to: 1}");
  const DiagnosedMachine machine = read_diagnosed_machine(MachineFile(wide).path, 1);
  ASSERT_EQ(machine.kits.size(), 60u);
  EXPECT_EQ(machine.kits[0].discs[0].mass_kg, 0.8);
  double low = 1, high = 0;
  int within = 0;
  for (const model::RotorKit& drawn : machine.kits) {
    low = std::min(low, drawn.discs[0].mass_kg);
    high = std::max(high, drawn.discs[0].mass_kg);
    within += drawn.discs[0].mass_kg > 0.6 && drawn.discs[0].mass_kg < 1;
  }
  EXPECT_LT(low, 0.68);
  EXPECT_GT(high, 0.92);
  EXPECT_GE(within, 54);
}

TEST(DiagnosedMachine, AFitOfAnotherMachineIsRefused) {
  const MachineFile file;
  file.write_fit("rotor.damping_ratio", 0.05, 0.045, 0.055);
  EXPECT_NE(refused(file).find("rotor.damping_ratio: is 0.02, but 0.05 in parameters.csv beside it"),
            std::string::npos);
}

TEST(DiagnosedMachine, TheFittedUnbalanceIsThatOfADayLikeIt) {
  const MachineFile file;
  file.write_fit("eccentricity_m", 1e-5, 0.9e-5, 1.1e-5);
  // Fitted names that are not keys of the machine are not compared with the configuration.
  const DiagnosedMachine machine = read_diagnosed_machine(file.path, 1);
  ASSERT_TRUE(machine.eccentricity_m);
  EXPECT_NEAR(machine.eccentricity_m->low, 0.9e-5 / 1.25, 1e-18);
  EXPECT_NEAR(machine.eccentricity_m->high, 1.1e-5 * 1.25, 1e-18);
}

TEST(DiagnosedMachine, GravityAndARotorWithoutDampingAreRefused) {
  EXPECT_NE(refused(MachineFile(jeffcott, "gravity_m_per_s2: 9.81")).find("gravity_m_per_s2: is not 0"),
            std::string::npos);
  EXPECT_NE(refused(MachineFile("{kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0}"))
                .find("rotor.damping_ratio: is 0, allowed: above 0"),
            std::string::npos);
}

TEST(DiagnosedMachine, AKitIsDrawnAndKnownAtOneSpeed) {
  const MachineFile file(kit);
  DiagnosedMachine machine = read_diagnosed_machine(file.path, 1);
  EXPECT_EQ(machine.kits.size(), 60u);
  machine.kits.resize(3);
  prepare_kits(file.path, 60, machine);
  ASSERT_TRUE(machine.fixed.kit);
  EXPECT_GT(machine.natural_frequency_hz.low, 0);
  EXPECT_EQ(machine.natural_frequency_hz.low, machine.natural_frequency_hz.high);
}

}  // namespace
}  // namespace rubsweep::diagnosis
