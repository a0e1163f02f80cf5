#pragma once

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::structure {

/// Steel shaft segment as in the examples of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines
/// (2010).
inline model::ShaftSegment steel_segment(double length_m, double outer_diameter_m,
                                         double inner_diameter_m = 0) {
  return {{.outer_diameter_m = outer_diameter_m,
           .inner_diameter_m = inner_diameter_m,
           .youngs_modulus_pa = 211e9,
           .shear_modulus_pa = 81.2e9,
           .density_kg_per_m3 = 7810},
          length_m};
}

inline model::Support isotropic_support(double position_m, double stiffness_n_per_m) {
  model::Support support;
  support.position_m = position_m;
  support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = stiffness_n_per_m;
  return support;
}

}  // namespace rubsweep::structure
