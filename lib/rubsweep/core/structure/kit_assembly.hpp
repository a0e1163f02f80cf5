#pragma once

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {

/// A reduced rotor kit with its casings, and how it was reduced.
struct KitAssembly {
  Assembly assembly;
  Reduction reduction;
};

/// Rotor kit of `machine` (whose rotor must be one) and its moving casings. Coordinates: shapes of the
/// shaft, pairs of x and y; then the angle of torsion where asked for; then x and y of every moving casing in
/// the order of the stops. The angle is coupled to nothing here: what couples it turns
/// with the shaft (scene::Twist). A rotor mass behind a restitution is the
/// modal mass, at the stop, of the first mode that is kept. The unbalance turns from +x towards +y: at t = 0
/// the mark of the shaft points along +x. Throws ConfigError where the supports do not hold the shaft, or a
/// stop without contact_mass_kg sits at a node of the first mode.
KitAssembly assemble_rotor_kit(const model::Machine& machine);

/// The same for one speed of many: where the kit says how many modes it keeps, without the receptance error of its
/// reduction.
KitAssembly assemble_kit_for_speed(const model::Machine& machine);

}  // namespace rubsweep::structure
