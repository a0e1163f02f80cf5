#pragma once

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {

/// A reduced rotor kit with its casings, and the reduction used.
struct KitAssembly {
  Assembly assembly;
  Reduction reduction;
};

/// Rotor kit of `machine` (whose rotor must be one) and its moving casings. Coordinates: shapes of the shaft
/// as pairs of x and y; the angle of torsion, if there is torsion; x and y of each moving casing in the order
/// of the stops. The angle is uncoupled here, because its coupling turns with the shaft (scene::Twist). The
/// rotor mass for a restitution is the modal mass of the first kept mode at the stop. The unbalance turns
/// from +x towards +y: at t = 0 the mark of the shaft points along +x. Throws ConfigError where the supports
/// do not hold the shaft, or a stop without contact_mass_kg is at a node of the first mode.
KitAssembly assemble_rotor_kit(const model::Machine& machine);

/// Rotor kit as by assemble_rotor_kit, for one of many speeds: if the kit gives its number of modes, the
/// receptance error of the reduction is not computed.
KitAssembly assemble_kit_for_speed(const model::Machine& machine);

}  // namespace rubsweep::structure
