#pragma once

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::scene {

/// The one-side machine as a rotor kit: an almost massless shaft on springs at both ends, with the disc at
/// the centre under the wall. In bending it is a Jeffcott rotor.
inline model::Machine light_shaft_machine() {
  model::Machine machine = one_side_machine();
  model::RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = 0.01,
                 .youngs_modulus_pa = 2.1e11,
                 .shear_modulus_pa = 8.1e10,
                 .density_kg_per_m3 = 1e-7},
                0.4}};
  kit.discs = {
      {.position_m = 0.2, .mass_kg = 0.8, .polar_inertia_kg_m2 = 4e-4, .diametral_inertia_kg_m2 = 2e-4}};
  for (const double end_m : {0.0, 0.4}) {
    model::Support support;
    support.position_m = end_m;
    support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 3e4;
    kit.supports.push_back(support);
  }
  kit.damping_ratio = {0.02};
  kit.modes = 1;
  kit.elements = 4;
  machine.rotor = kit;
  machine.stops.front().position_m = 0.2;
  return machine;
}

}  // namespace rubsweep::scene
