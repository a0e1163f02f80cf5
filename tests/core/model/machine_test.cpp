#include "rubsweep/core/model/machine.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/model/infinity.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::model {
namespace {

Stop rigid_stop() {
  Stop stop;
  stop.geometry = model::OneSideGeometry{90};
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 2e6;
  stop.damping = NominalRestitution{0.7};
  stop.contact_radius_m = 0.0375;
  return stop;
}

/// Two stops: the first on a moving casing, the second rigid.
Machine valid_machine() {
  Machine machine;
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
  machine.stops = {rigid_stop(), rigid_stop()};
  machine.stops[0].casing = {.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 0.1};
  machine.kick = {.force_n = 200, .duration_s = 0.005, .angle_deg = {}};
  return machine;
}

using Change = std::function<void(Machine&)>;

std::string message_after(const Change& change) {
  Machine machine = valid_machine();
  change(machine);
  return message_of<ConfigError>([&] { validate(machine); });
}

struct Case {
  Change change;
  std::string message;
};

TEST(MachineValidate, TakesAValidMachine) { EXPECT_NO_THROW(validate(valid_machine())); }

TEST(MachineValidate, NamesEveryNumberThatIsMissing) {
  const std::vector<Case> cases{
      {[](Machine& m) { std::get<model::JeffcottRotor>(m.rotor).mass_kg = required; },
       "rotor.mass_kg: missing, allowed: a number > 0"},
      {[](Machine& m) { std::get<model::JeffcottRotor>(m.rotor).natural_frequency_hz = required; },
       "rotor.natural_frequency_hz: missing, allowed: a number > 0"},
      {[](Machine& m) { std::get<model::JeffcottRotor>(m.rotor).damping_ratio = required; },
       "rotor.damping_ratio: missing, allowed: a number >= 0"},
      {[](Machine& m) { m.stops[1].geometry = {}; }, "stops.1.angle_deg: missing, allowed: a finite number"},
      {[](Machine& m) { m.stops[1].clearance_m = required; },
       "stops.1.clearance_m: missing, allowed: a number > 0"},
      {[](Machine& m) { m.stops[0].stiffness_n_per_m = required; },
       "stops.0.stiffness_n_per_m: missing, allowed: a number > 0"},
      {[](Machine& m) { m.stops[0].contact_radius_m = required; },
       "stops.0.contact_radius_m: missing, allowed: a number >= 0"},
      {[](Machine& m) { m.stops[1].damping = {}; },
       "stops.1.restitution: missing, allowed: a number > 0 and <= 1"},
      {[](Machine& m) { m.stops[0].damping = DeliveredRestitution{}; },
       "stops.0.restitution_delivered: missing, allowed: a number >= 0.2636 and <= 1"},
      {[](Machine& m) { m.stops[0].damping = ExplicitDamping{}; },
       "stops.0.damping_ns_per_m: missing, allowed: a number >= 0"},
      {[](Machine& m) { m.stops[1].friction = ConstantFriction{}; },
       "stops.1.friction.coefficient: missing, allowed: a number >= 0 and <= 10"},
      {[](Machine& m) { m.stops[0].casing->mass_kg = required; },
       "stops.0.casing.mass_kg: missing, allowed: a number > 0"},
      {[](Machine& m) { m.stops[0].casing->stiffness_n_per_m = required; },
       "stops.0.casing.stiffness_n_per_m: missing, allowed: a number > 0"},
      {[](Machine& m) { m.stops[1].casing.emplace(); },
       "stops.1.casing.mass_kg: missing, allowed: a number > 0"},
      {[](Machine& m) { m.stops[0].casing->damping_ratio = required; },
       "stops.0.casing.damping_ratio: missing, allowed: a number >= 0"},
      {[](Machine& m) { m.kick->force_n = required; }, "kick.force_n: missing, allowed: a number >= 0"},
      {[](Machine& m) { m.kick->duration_s = required; }, "kick.duration_s: missing, allowed: a number > 0"},
  };
  for (const Case& c : cases) EXPECT_EQ(message_after(c.change), c.message);
}

TEST(MachineValidate, WhatAStartMayBe) {
  const auto started = [](auto change) {
    return [change](Machine& m) {
      m.kick.reset();
      change(m.start.emplace());
    };
  };
  const std::vector<Case> cases{
      {[](Machine& m) { m.start.emplace(); },
       "start: is given beside a kick, allowed: one of the two, or rest"},
      {[](Machine& m) {
         m.start = {.at_rest = true};
         m.kick->phase_deg = 90;
       },
       "kick.phase_deg: is given beside start: rest, where no gap is smallest, allowed: nothing"},
      {started([](Start& s) { s.rotor.x_m = 101; }),
       "start.x_m: 101 is out of range, allowed: a number >= -100 and <= 100"},
      {started([](Start& s) { s.casings = {BodyState{.vy_m_per_s = infinity}}; }),
       "start.casings.0.vy_m_per_s: inf is out of range, allowed: a number >= -1000000 and <= 1000000"},
      {started([](Start& s) {
         s.casings = {std::nullopt, BodyState{}};
       }),
       "start.casings.1: there is no such casing, or it is rigid, allowed: a casing that moves"},
  };
  for (const Case& c : cases) EXPECT_EQ(message_after(c.change), c.message);
}

TEST(MachineValidate, AKickMayStandBesideRest) {
  Machine machine = valid_machine();
  ASSERT_TRUE(machine.kick);
  machine.start = {.at_rest = true};
  EXPECT_NO_THROW(validate(machine));
}

TEST(MachineValidate, NamesEveryNumberOutOfRange) {
  const std::vector<Case> cases{
      {[](Machine& m) { std::get<model::JeffcottRotor>(m.rotor).mass_kg = 0; },
       "rotor.mass_kg: 0 is out of range, allowed: a number > 0"},
      {[](Machine& m) { std::get<model::JeffcottRotor>(m.rotor).natural_frequency_hz = -30; },
       "rotor.natural_frequency_hz: -30 is out of range, allowed: a number > 0"},
      {[](Machine& m) { std::get<model::JeffcottRotor>(m.rotor).damping_ratio = infinity; },
       "rotor.damping_ratio: inf is out of range, allowed: a number >= 0"},
      {[](Machine& m) { m.stops[0].geometry = model::OneSideGeometry{-infinity}; },
       "stops.0.angle_deg: -inf is out of range, allowed: a finite number"},
      {[](Machine& m) { m.stops[1].clearance_m = 0; },
       "stops.1.clearance_m: 0 is out of range, allowed: a number > 0"},
      {[](Machine& m) { m.stops[0].contact_mass_kg = 0; },
       "stops.0.contact_mass_kg: 0 is out of range, allowed: a number > 0"},
      {[](Machine& m) { m.stops[0].damping = NominalRestitution{0}; },
       "stops.0.restitution: 0 is out of range, allowed: a number > 0 and <= 1"},
      {[](Machine& m) { m.stops[1].damping = DeliveredRestitution{1.01}; },
       "stops.1.restitution_delivered: 1.01 is out of range, allowed: a number >= 0.2636 and <= 1"},
      {[](Machine& m) { m.stops[1].damping = ExplicitDamping{-1}; },
       "stops.1.damping_ns_per_m: -1 is out of range, allowed: a number >= 0"},
      {[](Machine& m) { m.stops[1].friction = ConstantFriction{10.5}; },
       "stops.1.friction.coefficient: 10.5 is out of range, allowed: a number >= 0 and <= 10"},
      {[](Machine& m) {
         m.stops[1].friction = StribeckFriction{{0, 0, 0, 0.1, 100, infinity}};
       },
       "stops.1.friction.stribeck: inf is out of range, allowed: a finite number"},
      {[](Machine& m) { m.stops[0].casing->damping_ratio = -0.1; },
       "stops.0.casing.damping_ratio: -0.1 is out of range, allowed: a number >= 0"},
      {[](Machine& m) { m.kick->force_n = -1; }, "kick.force_n: -1 is out of range, allowed: a number >= 0"},
      {[](Machine& m) { m.kick->duration_s = 0; },
       "kick.duration_s: 0 is out of range, allowed: a number > 0"},
      {[](Machine& m) { m.kick->angle_deg = infinity; },
       "kick.angle_deg: inf is out of range, allowed: a finite number"},
      {[](Machine& m) { m.gravity_m_per_s2 = -9.81; },
       "gravity_m_per_s2: -9.81 is out of range, allowed: a number >= 0"},
  };
  for (const Case& c : cases) EXPECT_EQ(message_after(c.change), c.message);
}

TEST(MachineValidate, TakesTheEndsThatBelongToTheRanges) {
  Machine machine = valid_machine();
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0;
  machine.gravity_m_per_s2 = 0;
  machine.kick->force_n = 0;
  machine.stops[0].damping = NominalRestitution{1};
  machine.stops[0].contact_radius_m = 0;
  machine.stops[0].casing->damping_ratio = 0;
  machine.stops[0].friction = ConstantFriction{0};
  machine.stops[1].damping = ExplicitDamping{0};
  machine.stops[1].friction = ConstantFriction{10};
  EXPECT_NO_THROW(validate(machine));
}

TEST(MachineValidate, WithoutStopsThereIsNothingToTouch) {
  EXPECT_EQ(message_after([](Machine& m) { m.stops.clear(); }), "stops: at least one stop is needed");
}

TEST(MachineValidate, ReportsTheFirstOfSeveral) {
  EXPECT_EQ(message_of<ConfigError>([] { validate(Machine{}); }),
            "rotor.mass_kg: missing, allowed: a number > 0");
}

TEST(MachineKicks, ChangeTogetherInForceAndGoTogether) {
  const Machine machine = valid_machine();
  EXPECT_EQ(with_kick_force(machine, 50).kick->force_n, 50);
  EXPECT_EQ(with_kick_force(machine, 50).kick->duration_s, machine.kick->duration_s);
  EXPECT_EQ(with_kick_force(with_kick_force(machine, 0), 50).kick->force_n, 50);
  const Machine quiet = without_kicks(machine);
  EXPECT_FALSE(quiet.kick);
  int count = 0;
  for_each_kick(machine, [&](const Kick&, auto) { ++count; });
  for_each_kick(quiet, [&](const Kick&, auto) { count += 100; });
  EXPECT_EQ(count, 1);
}

TEST(MachineKicks, AreRecognisedByThePathsOfTheirKeys) {
  for (const char* path : {"kick.force_n", "kick.position_m", "kick"}) EXPECT_TRUE(is_of_kick(path)) << path;
  for (const char* path : {"kicked.force_n", "start.kick", "kic", ""}) EXPECT_FALSE(is_of_kick(path)) << path;
}

}  // namespace
}  // namespace rubsweep::model
