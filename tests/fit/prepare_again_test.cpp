#include "rubsweep/fit/prepare_again.hpp"

#include <gtest/gtest.h>

#include "rubsweep/error.hpp"
#include "scene/kit_machine.hpp"

namespace rubsweep::fit {
namespace {

model::Machine open_number_of_modes(double length_m) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.shaft.front().density_kg_per_m3 = 7850;
  kit.shaft.front().length_m = length_m;
  kit.supports.back().position_m = length_m;
  kit.modes = std::nullopt;
  kit.modes_up_to_hz = 400;
  return machine;
}

TEST(PrepareAgain, IsTheMachineThatIsPreparedAtOnce) {
  const model::Machine machine = open_number_of_modes(0.4);
  const scene::PreparedMachine first = scene::prepare_machine(machine);
  const scene::PreparedMachine again = prepare_again(machine, first);
  EXPECT_EQ(again.assembly.system.mass, first.assembly.system.mass);
  EXPECT_EQ(again.assembly.system.stiffness, first.assembly.system.stiffness);
  EXPECT_EQ(again.assembly.system.damping, first.assembly.system.damping);
}

TEST(PrepareAgain, KeepsTheNumberOfModes) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  const model::Machine longer = open_number_of_modes(0.8);
  const scene::PreparedMachine alone = scene::prepare_machine(longer);
  ASSERT_NE(alone.assembly.system.coordinates(), first.assembly.system.coordinates());
  EXPECT_EQ(prepare_again(longer, first).assembly.system.coordinates(), first.assembly.system.coordinates());
}

TEST(PrepareAgain, RefusesWhatIsNotAllowed) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  model::Machine machine = open_number_of_modes(0.4);
  std::get<model::RotorKit>(machine.rotor).discs.front().mass_kg = -1;
  EXPECT_THROW(prepare_again(machine, first), ConfigError);
}

}  // namespace
}  // namespace rubsweep::fit
