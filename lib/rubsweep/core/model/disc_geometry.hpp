#pragma once

#include <numbers>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Cylinder with a bore, of one material: dimensions from which a disc can be defined.
struct DiscGeometry {
  double outer_diameter_m = required;
  double inner_diameter_m = 0;
  double width_m = required;
  double density_kg_per_m3 = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("outer_diameter_m", self.outer_diameter_m, key(physical::diameter_m, "outer diameter of the disc"));
    visit("inner_diameter_m", self.inner_diameter_m, key(physical::hole_m, "diameter of its bore"));
    visit("width_m", self.width_m, key(physical::length_m, "width of the disc"));
    visit("density_kg_per_m3", self.density_kg_per_m3,
          key(physical::density_kg_per_m3, "density of the disc"));
  }

  double mass_kg() const {
    return density_kg_per_m3 * width_m * std::numbers::pi / 4 *
           (outer_diameter_m * outer_diameter_m - inner_diameter_m * inner_diameter_m);
  }
  double polar_inertia_kg_m2() const {
    return mass_kg() / 8 * (outer_diameter_m * outer_diameter_m + inner_diameter_m * inner_diameter_m);
  }
  double diametral_inertia_kg_m2() const {
    return polar_inertia_kg_m2() / 2 + mass_kg() * width_m * width_m / 12;
  }
};

}  // namespace rubsweep::model
