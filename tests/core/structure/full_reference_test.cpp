#include "rubsweep/core/structure/full_reference.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/structure/steel.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"

namespace rubsweep::structure {
namespace {

using std::numbers::pi;

/// A shaft with a stop in the middle and a seal at another place. The seal destabilises the first or the
/// second bending mode; the second mode has its node at the stop.
model::Machine fed_by_a_seal(double seal_at_m, double cross_n_per_m) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.6, 0.015)};
  kit.discs = {
      {.position_m = 0.15, .mass_kg = 1, .polar_inertia_kg_m2 = 1e-3, .diametral_inertia_kg_m2 = 6e-4},
      {.position_m = 0.45, .mass_kg = 1, .polar_inertia_kg_m2 = 1e-3, .diametral_inertia_kg_m2 = 6e-4}};
  kit.supports = {isotropic_support(0, 2e5), isotropic_support(0.6, 2e5), isotropic_support(seal_at_m, 0)};
  for (model::Support& support : kit.supports) {
    support.damping_x_ns_per_m = support.damping_y_ns_per_m = 20;
    // The first bending mode, which moves the seal least, is damped much more than the seal drives it.
  }
  kit.supports[2].stiffness_xy_n_per_m = cross_n_per_m, kit.supports[2].stiffness_yx_n_per_m = -cross_n_per_m;
  kit.modes_up_to_hz = 400;
  model::Machine machine;
  machine.rotor = kit;
  model::Stop& stop = machine.stops.emplace_back();
  stop.position_m = 0.3;
  stop.clearance_m = 3e-4, stop.stiffness_n_per_m = 1e6, stop.contact_radius_m = 0.02;
  stop.damping = model::ExplicitDamping{10};
  return machine;
}

bool mistaken(const model::Machine& machine, const KitAssembly& kit) {
  const model::RotorKit& given = *model::kit_of(machine);
  return growth_is_mistaken(assemble_beam_shaft(given, {*machine.stops[0].position_m}), given, kit.assembly,
                            2 * pi * 30);
}

TEST(FullReference, TellsGrowthThatTheModesOfAKitLack) {
  // Against the shaft's rotation: the seal drives backward whirl in all modes that move the seal.
  model::Machine machine = fed_by_a_seal(0.15, 1e5);
  EXPECT_FALSE(mistaken(machine, assemble_rotor_kit(machine)));
  KitAssembly other = assemble_rotor_kit(fed_by_a_seal(0.15, 0));
  EXPECT_TRUE(mistaken(machine, other));
  EXPECT_TRUE(mistaken(fed_by_a_seal(0.15, 100), assemble_rotor_kit(machine)));
  // These matrices contain no destabilising forces, so no check is needed.
  EXPECT_FALSE(mistaken(fed_by_a_seal(0.15, 0), other));
}

TEST(FullReference, AnAutomaticNumberOfModesThatIsNotEnoughIsRefused) {
  model::Machine machine = fed_by_a_seal(0.15, 0);
  model::kit_of(machine)->modes_up_to_hz = 1e6;
  const std::string message = message_of<ConfigError>([&] { assemble_rotor_kit(machine); });
  EXPECT_TRUE(message.starts_with("rotor.modes: auto does not answer as the full matrices do up to 1000000"))
      << message;
}

TEST(FullReference, AFixedNumberOfModesThatMistakesStabilityIsRefused) {
  // The seal is at the node of the first bending mode of an overhung shaft: the second mode grows.
  model::Machine machine = fed_by_a_seal(0.15, 3e4);
  model::RotorKit& kit = *model::kit_of(machine);
  for (std::size_t i = 0; i < 2; ++i)
    kit.supports[i].damping_x_ns_per_m = kit.supports[i].damping_y_ns_per_m = 400;
  ASSERT_GT(assemble_rotor_kit(machine).reduction.modes, 1);
  kit.modes = 1;
  const std::string message = message_of<ConfigError>([&] { assemble_rotor_kit(machine); });
  EXPECT_TRUE(message.starts_with("rotor.modes: with so few modes")) << message;
}

}  // namespace
}  // namespace rubsweep::structure
