#pragma once

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// One body of a line contact. `radius_m` of a flat casing is not needed and stays NaN.
struct HertzBody {
  double radius_m = required;
  double youngs_modulus_pa = required;
  double poisson_ratio = required;

  static constexpr Range poisson_range{.low = 0, .high = 0.5};

  static void visit_material(auto& self, auto&& visit) {
    visit("youngs_modulus_pa", self.youngs_modulus_pa, positive);
    visit("poisson_ratio", self.poisson_ratio, poisson_range);
  }
};

enum class HertzShape { cylinder, flat, hole };  ///< the casing's: convex, plane, or around the rotor
enum class HertzHalfWidth { textbook, paper };   ///< which formula gives the width of the contact

/// Parallel cylinders that touch along a line: where the stiffness of a contact comes from.
struct HertzLine {
  double length_m = required;
  HertzBody rotor;
  HertzBody casing;
  HertzShape casing_shape = HertzShape::cylinder;
  double design_force_n = required;  ///< the stiffness is the secant at this force
  HertzHalfWidth half_width = HertzHalfWidth::textbook;
};

}  // namespace rubsweep::model
