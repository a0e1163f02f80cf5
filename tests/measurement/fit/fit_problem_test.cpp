#include "rubsweep/measurement/fit/fit_problem.hpp"

#include <gtest/gtest.h>

#include "core/scene/table_machine.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

TEST(FitProblem, TakesANumberFromTheParametersWhereItIsOne) {
  MachineFit problem;
  problem.parameters = {{.name = "rotor.damping_ratio"}, {.name = mark_name}};
  const Eigen::Vector2d values(0.02, 40);
  EXPECT_EQ(value_named(problem, values, mark_name, 7), 40);
  EXPECT_EQ(value_named(problem, values, hit_name, 7), 7);
}

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

TEST(FitProblem, IsTheMachineThatIsPreparedAtOnce) {
  const model::Machine machine = open_number_of_modes(0.4);
  const scene::PreparedMachine first = scene::prepare_machine(machine);
  const scene::PreparedMachine again = prepare_again(machine, first);
  EXPECT_EQ(again.assembly.system.mass, first.assembly.system.mass);
  EXPECT_EQ(again.assembly.system.stiffness, first.assembly.system.stiffness);
  EXPECT_EQ(again.assembly.system.damping, first.assembly.system.damping);
}

TEST(FitProblem, KeepsTheNumberOfModes) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  const model::Machine longer = open_number_of_modes(0.8);
  const scene::PreparedMachine alone = scene::prepare_machine(longer);
  ASSERT_NE(alone.assembly.system.coordinates(), first.assembly.system.coordinates());
  EXPECT_EQ(prepare_again(longer, first).assembly.system.coordinates(), first.assembly.system.coordinates());
}

TEST(FitProblem, RefusesWhatIsNotAllowed) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  model::Machine machine = open_number_of_modes(0.4);
  std::get<model::RotorKit>(machine.rotor).discs.front().mass_kg = -1;
  EXPECT_THROW(prepare_again(machine, first), ConfigError);
}

TEST(FitProblem, SupportsFollowTheirTables) {
  const model::Machine machine = scene::table_machine();
  const scene::PreparedMachine first = scene::prepare_machine(machine), again = prepare_again(machine, first);
  for (const double speed_hz : scene::table_speeds_hz) {
    const scene::PreparedMachine there = scene::prepared_at(again, speed_hz),
                                 expected = scene::prepared_at(first, speed_hz);
    EXPECT_EQ(there.assembly.system.stiffness, expected.assembly.system.stiffness) << speed_hz;
    EXPECT_EQ(there.assembly.system.damping, expected.assembly.system.damping) << speed_hz;
  }
  EXPECT_NE(scene::prepared_at(again, scene::table_speeds_hz.front()).assembly.system.stiffness,
            scene::prepared_at(again, scene::table_speeds_hz.back()).assembly.system.stiffness);
  EXPECT_THROW(scene::prepared_at(again, 19), ConfigError);
}

TEST(FitProblem, RefusesFrictionThatDrives) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  model::Machine machine = open_number_of_modes(0.4);
  machine.stops.front().friction = model::StribeckFriction{{0, 0, 0, -0.1, 100, 0}};
  EXPECT_THROW(scene::prepare_machine(machine), ConfigError);
  EXPECT_THROW(prepare_again(machine, first), ConfigError);
}

}  // namespace
}  // namespace rubsweep::fit
