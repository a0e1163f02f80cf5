#include "rubsweep/core/scene/prepared_machine.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "core/scene/kit_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::scene {
namespace {

std::string refusal(const std::function<void(model::RotorKit&)>& change) {
  model::Machine machine = light_shaft_machine();
  change(*model::kit_of(machine));
  return message_of<ConfigError>([&] { prepare_machine(machine); });
}

TEST(PreparedMachinePrepare, RefusesNumbersThatNoShaftHas) {
  EXPECT_NE(refusal([](auto& kit) { kit.shaft[0].outer_diameter_m = 1e-300; })
                .find("rotor.shaft.0.outer_diameter_m: 1e-300 is out of range, allowed: a number >= 1e-06 "
                      "and <= 100"),
            std::string::npos);
  EXPECT_NE(refusal([](auto& kit) { kit.shaft[0].outer_diameter_m = 1e100; }).find("is out of range"),
            std::string::npos);
}

TEST(PreparedMachinePrepare, AnotherKickLeavesTheStructure) {
  const model::Machine machine = light_shaft_machine();
  model::Machine other = machine;
  *other.kick = {.force_n = 50, .duration_s = 0.002, .angle_deg = 30, .position_m = {}, .phase_deg = 40};
  const auto scene_of = [](const PreparedMachine& prepared) {
    return build_cell(prepared, 60, WhirlRatio{0.5}).scene;
  };
  const scene::Scene anew = scene_of(prepare_machine(other)),
                     taken_over = scene_of(prepare_other_kick(prepare_machine(machine), other));
  EXPECT_EQ(taken_over.structure.stiffness, anew.structure.stiffness);
  EXPECT_EQ(taken_over.structure.damping, anew.structure.damping);
  EXPECT_EQ(taken_over.structure.mass, anew.structure.mass);
  EXPECT_EQ(taken_over.harmonic_n, anew.harmonic_n);
  ASSERT_EQ(taken_over.pulses.size(), 1u);
  EXPECT_EQ(taken_over.pulses[0].force_n, 50);
  EXPECT_EQ(taken_over.pulses[0].duration_s, anew.pulses.at(0).duration_s);
  EXPECT_EQ(taken_over.pulses[0].direction, anew.pulses.at(0).direction);
}

TEST(PreparedMachineAt, IsTheMachineWithTheNumbersTypedIn) {
  for (const std::optional<int> modes : {std::optional<int>(2), std::optional<int>()}) {
    const PreparedMachine prepared = prepare_machine(table_machine(modes));
    for (std::size_t row = 0; row < table_speeds_hz.size(); ++row) {
      const double speed_hz = table_speeds_hz[row];
      const Scene found = build_cell(prepared_at(prepared, speed_hz), speed_hz, WhirlRatio{0.5}).scene,
                  typed = build_cell(typed_machine(row, modes), speed_hz, WhirlRatio{0.5}).scene;
      EXPECT_EQ(found.structure.stiffness, typed.structure.stiffness);
      EXPECT_EQ(found.structure.damping, typed.structure.damping);
      EXPECT_EQ(found.structure.mass, typed.structure.mass);
      EXPECT_EQ(found.harmonic_n, typed.harmonic_n);
      EXPECT_EQ(found.displacement_m, typed.displacement_m);
      EXPECT_EQ(found.contacts[0].damping_ns_per_m, typed.contacts[0].damping_ns_per_m);
    }
  }
}

TEST(PreparedMachineAt, NoCellIsBuiltBeyondATable) {
  const PreparedMachine prepared = prepare_machine(table_machine());
  for (const double speed_hz : {19.0, 121.0}) {
    EXPECT_THROW(prepared_at(prepared, speed_hz), ConfigError);
    EXPECT_THROW(build_cell(prepared, speed_hz, WhirlRatio{0.5}), ConfigError);
  }
}

TEST(PreparedMachineAt, KeepsTheKickOfTheMachineThatAsks) {
  const PreparedMachine prepared = prepare_machine(table_machine());
  model::Machine other = prepared.machine;
  other.kick->force_n = 77;
  const PreparedMachine there = prepared_at(prepare_other_kick(prepared, other), 55);
  EXPECT_EQ(there.machine.kick->force_n, 77);
  EXPECT_EQ(there.assembly.system.stiffness, prepared_at(prepared, 55).assembly.system.stiffness);
}

TEST(PreparedMachineAt, LeavesAMachineWithoutTables) {
  const PreparedMachine prepared = prepare_machine(light_shaft_machine());
  EXPECT_EQ(prepared_at(prepared, 17).assembly.system.stiffness, prepared.assembly.system.stiffness);
}

TEST(PreparedMachinePrepare, AnotherKickMustBeAllowed) {
  model::Machine machine = light_shaft_machine();
  const PreparedMachine prepared = prepare_machine(machine);
  machine.kick->duration_s = -1;
  EXPECT_NE(
      message_of<ConfigError>([&] { prepare_other_kick(prepared, machine); }).find("kick.duration_s: -1"),
      std::string::npos);
}

/// Sets every number to either end of its allowed range, one at a time; the machine is prepared or refused.
TEST(PreparedMachinePrepare, TakesOrRefusesEveryAllowedExtreme) {
  const auto with_a_few_of_everything = [] {
    model::Machine machine = light_shaft_machine();
    model::RotorKit& kit = *model::kit_of(machine);
    kit.shaft[0].density_kg_per_m3 = 7850;
    kit.modes.reset();
    kit.couplings = {
        {.position_m = 0.3, .lateral_stiffness_n_per_m = 1e7, .angular_stiffness_nm_per_rad = 1e3}};
    kit.supports[0].pedestal =
        model::Pedestal{.mass_kg = 2, .stiffness_x_n_per_m = 1e5, .stiffness_y_n_per_m = 1e5};
    kit.bow = model::Bow{.shape = model::BowMode{.mode = 2, .amplitude_m = 1e-5}, .phase_deg = 0};
    return machine;
  };
  int numbers = 0, plans = 0;
  for (int target = 0;; ++target) {
    bool reached = false;
    for (const bool high : {false, true}) {
      model::Machine machine = with_a_few_of_everything();
      int count = 0;
      const auto change = [&](const char* name, auto& value, const model::Range& range) {
        if (count++ != target || std::string(name) == "position_m") return;
        reached = true;
        value = high ? range.high : range.low;
      };
      const auto visit = [&](auto& part) {
        std::remove_reference_t<decltype(part)>::visit_fields(part, change);
      };
      model::RotorKit& kit = *model::kit_of(machine);
      visit(kit.shaft[0]);
      visit(kit.discs[0]);
      visit(kit.supports[0]);
      visit(*kit.supports[0].pedestal);
      visit(kit.couplings[0]);
      reached = reached || target < count;
      if (!reached) break;
      try {
        prepare_machine(machine);
        ++plans;
      } catch (const ConfigError&) {
      }
      ++numbers;
    }
    if (!reached) break;
  }
  EXPECT_GT(numbers, 50);
  EXPECT_GT(plans, 20);
}

TEST(PreparedMachinePrepare, ABowInAModeThatTheShaftHasNotIsRefused) {
  EXPECT_NE(refusal([](auto& kit) {
              kit.elements = 1;
              kit.bow = model::Bow{.shape = model::BowMode{.mode = 40, .amplitude_m = 1e-5}, .phase_deg = 0};
            }).find("rotor.bow.mode: the shaft has fewer modes"),
            std::string::npos);
}

TEST(PreparedMachinePrepare, ACouplingNeedsShaftOnBothSides) {
  for (const double place : {1e-12, 0.4 - 1e-12}) {
    EXPECT_NE(
        refusal([&](auto& kit) {
          kit.couplings = {
              {.position_m = place, .lateral_stiffness_n_per_m = 1e7, .angular_stiffness_nm_per_rad = 1e3}};
        }).find("rotor.couplings.0.position_m: "),
        std::string::npos);
  }
}

TEST(PreparedMachine, IsTheMachineThatSaysSoManyModes) {
  for (const int modes : {1, 2}) {
    const PreparedMachine expected = prepare_machine(table_machine(modes)),
                          found = prepare_with_modes(table_machine(3), modes);
    EXPECT_EQ(found.assembly.system.mass, expected.assembly.system.mass) << modes;
    EXPECT_EQ(found.assembly.system.stiffness, expected.assembly.system.stiffness) << modes;
    EXPECT_EQ(found.assembly.system.damping, expected.assembly.system.damping) << modes;
  }
}

TEST(PreparedMachine, KeepsTheirNumberAtEverySpeed) {
  const PreparedMachine open = prepare_with_modes(table_machine(std::nullopt), 1);
  for (const double speed_hz : table_speeds_hz)
    EXPECT_EQ(prepared_at(open, speed_hz).assembly.system.coordinates(),
              prepared_at(prepare_machine(table_machine(1)), speed_hz).assembly.system.coordinates());
}

TEST(PreparedMachine, RefusesWhatIsNotAllowed) {
  model::Machine machine = table_machine();
  model::kit_of(machine)->discs.front().mass_kg = -1;
  EXPECT_THROW(prepare_with_modes(machine, 1), ConfigError);
}

}  // namespace
}  // namespace rubsweep::scene
