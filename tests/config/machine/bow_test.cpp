#include "rubsweep/config/machine/bow.hpp"

#include <variant>

#include "config/support.hpp"

namespace rubsweep::config::machine {
namespace {

model::Bow bow_with(const std::vector<std::string>& overrides) {
  const model::Machine machine =
      read_run_config_text(test_file("rotor_kit.yaml"), "kit.yaml", overrides).study.machine;
  return model::kit_of(machine)->bow.value();
}

TEST(Bow, IsALineThroughPoints) {
  const model::Bow bow = bow_with({});
  EXPECT_EQ(std::get<model::BowPoints>(bow.shape).deflection_m, (std::vector<double>{0, 1e-5, 0}));
  EXPECT_EQ(bow.phase_deg, 30);
}

TEST(Bow, IsAModeInsteadOfALine) {
  const model::Bow bow = bow_with({"rotor.bow={mode: 2, amplitude_m: 1e-4}"});
  EXPECT_EQ(std::get<model::BowMode>(bow.shape).mode, 2);
  EXPECT_EQ(std::get<model::BowMode>(bow.shape).amplitude_m, 1e-4);
}

TEST(Bow, ProblemsHaveTheirPlaces) {
  EXPECT_NE(kit_message({"rotor.bow={mode: 1}"}).find("rotor.bow.amplitude_m: missing"), std::string::npos);
  EXPECT_NE(kit_message({"rotor.bow={phase_deg: 1}"})
                .find("rotor.bow: one key is missing, allowed: exactly one of mode, position_m"),
            std::string::npos);
  EXPECT_NE(
      kit_message({"rotor.bow.position_m=[0, 0.1, 2]"}).find("rotor.bow.position_m.2: 2 is out of range"),
      std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::machine
