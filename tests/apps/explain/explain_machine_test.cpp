#include "explain/explain_machine.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/scene/kit_machine.hpp"
#include "maps/report/says.hpp"

namespace rubsweep::apps {
using report::says;

namespace {

TEST(ExplainMachine, MovingCasing) {
  const std::string text = explain_machine(scene::one_side_machine(), 45);
  EXPECT_TRUE(
      says(text, "rotor: Jeffcott, moves in x and y (2 coordinates), 0.8 kg, 30 Hz, damping ratio 0.02\n"));
  EXPECT_TRUE(says(text, "stop 0 (kicked): one side at 90 degrees, clearance 0.001 m\n"));
  // Casing frequency sqrt(5e5 / 0.05) / (2 pi) Hz; contact half-period pi sqrt(0.8 * 0.05 / 0.85 / 2e6) s.
  EXPECT_TRUE(says(text,
                   "casing: moves in x and y (2 coordinates), 0.05 kg, 503.3 Hz, damping ratio 0.1; contact "
                   "half-period 0.482 ms\n"));
  // Nominal restitution 0.7: damping ratio |ln 0.7| / sqrt(pi^2 + ln^2 0.7) = 0.11282, with which the clamped
  // law gives 0.736.
  EXPECT_TRUE(says(text, "clamped ElastoGap, 2000000 N/m, 69.2161 N s/m"));
  EXPECT_TRUE(says(text, "(damping ratio 0.1128; a free impact returns 0.736"));
  EXPECT_TRUE(says(text, "kick: half-sine, 200 N for 0.005 s\n"));
  EXPECT_TRUE(says(text, "states: 8 (4 coordinates and their rates)\n"));
  EXPECT_TRUE(says(text, "left out: torsion"));
  EXPECT_TRUE(says(text, "left out: gravity"));
  EXPECT_FALSE(says(text, "left out: friction"));
}

TEST(ExplainMachine, RotorKitSaysWhatItWasReducedTo) {
  model::Machine machine = scene::light_shaft_machine();
  model::kit_of(machine)->shaft[0].density_kg_per_m3 = 7850;
  const std::string text = explain_machine(machine, 45);
  EXPECT_TRUE(says(text, "rotor: kit, shaft of 0.4 m in 4 or more Timoshenko elements, 1 discs, 2 supports"));
  EXPECT_TRUE(says(text, "  reduced in x to modes 1 ("));
  EXPECT_TRUE(says(text, "; attachment modes of the stops "));
  EXPECT_TRUE(says(text, "number of modes: as configured\n"));
  EXPECT_TRUE(says(text, "  at 0.2 m of the shaft; mass behind the contact "));
  EXPECT_TRUE(says(text, "states: 12 (6 coordinates and their rates)\n"));
  const std::string named = explain_machine(scene::both_sides_machine(), 45, {"upper", "lower"});
  EXPECT_TRUE(says(named, "stop 0 (upper) (kicked): one side at 90 degrees"));
  EXPECT_TRUE(says(named, "stop 1 (lower): one side at -90 degrees"));
  EXPECT_FALSE(says(text, "tilting"));
  EXPECT_FALSE(says(text, "  supports: "));
  model::kit_of(machine)->supports[1].name = "BearingElement_Free end";
  EXPECT_TRUE(says(explain_machine(machine, 45), "  supports: 1 (BearingElement_Free end) at 0.4 m\n"));
  model::kit_of(machine)->modes.reset();
  EXPECT_TRUE(says(explain_machine(machine, 45), "number of modes: auto, the smallest within 0.01\n"));
}

TEST(ExplainMachine, FaultyBearingsSayWhatCannotBeProven) {
  model::Machine machine = scene::light_shaft_machine();
  EXPECT_FALSE(says(explain_machine(machine, 45), "impulses"));
  model::kit_of(machine)->supports[1].fault = {.impulse_ns = 0.02, .multiple = 2, .angle_deg = 90};
  const std::string text = explain_machine(machine, 45);
  EXPECT_TRUE(says(text, "faulty bearing at 0.4 m: 2 impulses of 0.02 N s per revolution at 90 degrees"));
  EXPECT_TRUE(says(text, "nothing is ever proven to rest"));
  EXPECT_FALSE(says(text, "no proof of a period"));
  model::kit_of(machine)->supports[1].fault->multiple = 2.5;
  EXPECT_TRUE(says(explain_machine(machine, 45), "no proof of a period"));
}

TEST(ExplainMachine, RigidCasingHasNoState) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].casing.reset();
  machine.gravity_m_per_s2 = 9.81;
  machine.stops[0].friction = model::NoFriction{};
  machine.kick.reset();
  const std::string text = explain_machine(machine, 45);
  EXPECT_TRUE(says(text, "states: 4 (2 coordinates and their rates)\n"));
  EXPECT_TRUE(says(text, "casing: rigid, no state; contact half-period 1.99 ms\n"));  // pi sqrt(0.8 / 2e6)
  EXPECT_TRUE(says(text, "kick: none\n"));
  machine.start.emplace();
  EXPECT_TRUE(says(explain_machine(machine, 45), "start: in a given state, not kicked"));
  machine.start->at_rest = true;
  EXPECT_TRUE(says(explain_machine(machine, 45), "weight act from then on\nkick: none\n"));
  machine.kick = model::Kick{30, 0.01, {}};
  EXPECT_TRUE(says(explain_machine(machine, 45), "weight act from then on\nkick: half-sine, 30 N"));
  EXPECT_FALSE(says(text, "left out: gravity"));
  EXPECT_TRUE(says(text, "left out: friction (no stop has any)\n"));
}

TEST(ExplainMachine, EveryStopInTurn) {
  const std::string text = explain_machine(scene::both_sides_machine(), 45);
  EXPECT_TRUE(says(text, "stop 0 (kicked): one side at 90 degrees"));
  EXPECT_TRUE(says(text, "stop 1: one side at -90 degrees"));
  EXPECT_TRUE(says(text, "states: 12 (6 coordinates and their rates)\n"));
}

std::string explained(const model::Machine& machine, double speed_hz) {
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  return explain_stop(prepared, scene::build_cell(prepared, speed_hz, scene::WhirlRatio{0}), 0);
}

TEST(ExplainMachineExplainStop, AContactThatIsFasterThanTheModesAreChosenForIsSaid) {
  model::Machine machine = scene::light_shaft_machine();
  EXPECT_FALSE(says(explained(machine, 45), "contact is faster"));
  machine.stops[0].stiffness_n_per_m *= 1e4;
  EXPECT_TRUE(says(explained(machine, 45), "largest forces depend on rotor.modes\n"));
}

TEST(ExplainMachineExplainStop, FrictionSaturatedOrNotAtTheStatedSpeed) {
  model::Machine machine = scene::one_side_machine();
  // Surface speed: 0.0375 m times 2 pi 45 rad/s is 10.603 m/s.
  EXPECT_TRUE(says(explained(machine, 45),
                   "friction: Stribeck, 0.1 at the surface speed 10.6 m/s of the lowest speed (saturated"));
  // tanh(100 * 0.0375 * 2 pi * 0.1) is still below 1.
  EXPECT_TRUE(says(explained(machine, 0.1), "(depends on the slip)"));
  machine.stops[0].friction = model::ConstantFriction{0.25};
  EXPECT_TRUE(says(explained(machine, 45),
                   "friction: dry 0.25; reverses with the slip, and may hold the surfaces together"));
  machine.stops[0].friction = model::OneWayFriction{0.25};
  EXPECT_TRUE(says(explained(machine, 45),
                   "friction: one-way 0.25; a run whose slip would reverse says slip_reversal"));
  machine.stops[0].friction = model::NoFriction{};
  EXPECT_TRUE(says(explained(machine, 45), "friction: none\n"));
}

TEST(ExplainMachineExplainStop, DampingWithoutReboundAndWithoutLoss) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].damping = model::ExplicitDamping{1e4};
  EXPECT_TRUE(says(explained(machine, 45),
                   "beyond critical, so that a free impact returns less than 0.2636 of its speed"));
  machine.stops[0].damping = model::NominalRestitution{1};
  EXPECT_TRUE(
      says(explained(machine, 45), " 0 N s/m (damping ratio 0; a free impact returns 1 of its speed)"));
}

TEST(ExplainMachineExplainStop, ACurvedLawAndWhatItsDampingReturns) {
  model::Machine machine = scene::one_side_machine();
  model::NormalLaw& law = machine.stops[0].law;
  law.kind = model::ForceCurve::power;
  law.stiffness_n_per_m_n = 3e8;
  law.exponent = 1.5;
  law.damping = model::ImpactDamping::hunt_crossley;
  law.restitution = 0.7;
  law.approach_speed_m_per_s = 0.2;
  const std::string text = explained(machine, 45);
  EXPECT_TRUE(says(text, "  force law: 300000000 N/m^1.5 p^1.5; secant at a twentieth of the clearance "));
  // Damping factor 3 (1 - 0.7) / 2.
  EXPECT_TRUE(
      says(text, "  contact damping: hunt_crossley with restitution 0.7, 1 + 0.45 p' / v0, v0 0.2 m/s\n"));
  EXPECT_FALSE(says(text, "the motion goes by how each contact began"));
  law.approach_speed_m_per_s.reset();
  EXPECT_TRUE(says(explained(machine, 45), "v0 the speed of each approach\n"));
  EXPECT_TRUE(
      says(explained(machine, 45), "the motion goes by how each contact began: no proof of a period"));
  law.damping = model::ImpactDamping::none;
  EXPECT_TRUE(says(explained(machine, 45), "  contact damping: none\n"));
}

}  // namespace
}  // namespace rubsweep::apps
