#include "rubsweep/maps/report/explain_stop.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/scene/kit_machine.hpp"
#include "maps/report/says.hpp"

namespace rubsweep::report {
namespace {

std::string explained(const model::Machine& machine, double speed_hz) {
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  return explain_stop(prepared, scene::build_cell(prepared, speed_hz, scene::WhirlRatio{0}), 0);
}

TEST(ExplainStop, AContactThatIsFasterThanTheModesAreChosenForIsSaid) {
  model::Machine machine = scene::light_shaft_machine();
  EXPECT_FALSE(says(explained(machine, 45), "contact is faster"));
  machine.stops[0].stiffness_n_per_m *= 1e4;
  EXPECT_TRUE(says(explained(machine, 45), "largest forces depend on rotor.modes\n"));
}

TEST(ExplainStop, FrictionSaturatedOrNotAtTheStatedSpeed) {
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

TEST(ExplainStop, DampingWithoutReboundAndWithoutLoss) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].damping = model::ExplicitDamping{1e4};
  EXPECT_TRUE(says(explained(machine, 45),
                   "beyond critical, so that a free impact returns less than 0.2636 of its speed"));
  machine.stops[0].damping = model::NominalRestitution{1};
  EXPECT_TRUE(
      says(explained(machine, 45), " 0 N s/m (damping ratio 0; a free impact returns 1 of its speed)"));
}

TEST(ExplainStop, ACurvedLawAndWhatItsDampingReturns) {
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
}  // namespace rubsweep::report
