#pragma once

#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::diagnose {

/// A rotor kit that acts as a Jeffcott rotor of 0.8 kg in bending; its probe is not at the disc.
inline model::RotorKit light_kit() {
  const model::Machine machine = scene::light_shaft_machine();
  model::RotorKit kit = *model::kit_of(machine);
  kit.sensors = {{.position_m = 0.15}, {.position_m = 0.15, .angle_deg = 90}};
  return kit;
}

}  // namespace rubsweep::diagnose
