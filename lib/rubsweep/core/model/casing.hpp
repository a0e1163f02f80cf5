#pragma once

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Casing of one stop, free to move in x and y on an isotropic mount. A stop without a Casing is rigid and
/// adds no state.
struct Casing {
  double mass_kg = required;
  double stiffness_n_per_m = required;  ///< mount stiffness, the same in x and y
  double damping_ratio = required;      ///< damping ratio of the mount: c / (2 sqrt(k m))

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, key(positive, "mass of the casing"));
    visit("stiffness_n_per_m", self.stiffness_n_per_m,
          key(positive, "stiffness of its mount, the same in x and y"));
    visit("damping_ratio", self.damping_ratio,
          key(not_negative, "damping of its mount as a fraction of critical damping"));
  }
};

}  // namespace rubsweep::model
