#pragma once

#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::integrate {

/// A gyroscopic shaft whose disc tilts and rubs on a stiff wall. With the contact released, its modes are
/// almost linearly dependent.
inline scene::Scene kit_scene(double speed_hz, double whirl_ratio) {
  model::Machine machine = scene::light_shaft_machine();
  model::kit_of(machine)->shaft[0].density_kg_per_m3 = 7850;
  model::kit_of(machine)->modes = 3;
  model::Stop& stop = machine.stops[0];
  stop.position_m = 0.29;
  stop.stiffness_n_per_m = 1.2e8;
  stop.contact_radius_m = 5e-3;
  stop.casing = {.mass_kg = 0.03, .stiffness_n_per_m = 1.18e6, .damping_ratio = 0.05};
  machine.kick->position_m = 0.2;
  return scene::build_cell(machine, speed_hz, scene::WhirlRatio{whirl_ratio}).scene;
}

}  // namespace rubsweep::integrate
