#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/require.hpp"

namespace rubsweep::model {

/// Shear coefficient of a section: the mean shear strain is Q / (coefficient G A).
enum class ShearCoefficient {
  cowper,      ///< Cowper, J. Appl. Mech. 33, 1966
  hutchinson,  ///< Hutchinson, J. Appl. Mech. 68, 2001
  none         ///< no shear: sections stay normal to the axis
};

/// Round section and material of a segment of shaft, or of a further layer around or inside it. Both ends of
/// a layer turn with those of its segment.
struct ShaftLayer {
  double outer_diameter_m = required;
  double inner_diameter_m = 0;
  /// At the end of the segment; the diameters change linearly from those above. Empty: they do not.
  std::optional<double> outer_diameter_end_m = std::nullopt, inner_diameter_end_m = std::nullopt;
  /// Diameters that bend and shear, where they are others than those that have mass. Empty: the same.
  std::optional<double> stiffness_outer_diameter_m = std::nullopt, stiffness_inner_diameter_m = std::nullopt;
  double youngs_modulus_pa = required;
  double shear_modulus_pa = required;
  double density_kg_per_m3 = required;
  /// Damping against motion in space and against bending: matrices mass_damping_per_s times the mass and
  /// stiffness_damping_s times the stiffness of each element. It does not turn with the shaft.
  double mass_damping_per_s = 0;
  double stiffness_damping_s = 0;
  ShearCoefficient shear_coefficient = ShearCoefficient::cowper;
  bool rotary_inertia = true;
  bool gyroscopic = true;

  static void visit_fields(auto& self, auto&& visit) {
    visit("outer_diameter_m", self.outer_diameter_m, physical::diameter_m);
    visit("inner_diameter_m", self.inner_diameter_m, physical::hole_m);
    visit("outer_diameter_end_m", self.outer_diameter_end_m, physical::diameter_m);
    visit("inner_diameter_end_m", self.inner_diameter_end_m, physical::hole_m);
    visit("stiffness_outer_diameter_m", self.stiffness_outer_diameter_m, physical::diameter_m);
    visit("stiffness_inner_diameter_m", self.stiffness_inner_diameter_m, physical::hole_m);
    visit("youngs_modulus_pa", self.youngs_modulus_pa, physical::modulus_pa);
    visit("shear_modulus_pa", self.shear_modulus_pa, physical::modulus_pa);
    visit("density_kg_per_m3", self.density_kg_per_m3, physical::density_kg_per_m3);
    visit("mass_damping_per_s", self.mass_damping_per_s, physical::rate_per_s);
    visit("stiffness_damping_s", self.stiffness_damping_s, physical::duration_s);
  }
};

/// Piece of shaft between two stations. Positions along the shaft count from the free end of the first
/// segment.
struct ShaftSegment : ShaftLayer {
  double length_m = required;
  std::vector<ShaftLayer> layers{};  ///< beside the segment's own section, over all of its length

  static void visit_fields(auto& self, auto&& visit) {
    visit("length_m", self.length_m, physical::length_m);
    ShaftLayer::visit_fields(self, visit);
  }
};

/// Diameters of a section.
struct Diameters {
  double outer_m = 0;
  double inner_m = 0;
};

/// Diameters that have mass, `at` this share of the segment's length, 0 to 1.
Diameters diameters(const ShaftLayer& layer, double at);

/// Diameters that bend and shear.
Diameters stiffness_diameters(const ShaftLayer& layer, double at);

/// Whether the section changes along the segment.
bool is_tapered(const ShaftLayer& layer);

/// Mass of a segment with its layers.
double mass_kg(const ShaftSegment& segment);

/// Problem of diameters that are each in their range: no wall is left, or a taper has stiffness diameters of
/// its own. Empty: none.
std::optional<PartProblem> diameter_problem(const ShaftLayer& layer);

}  // namespace rubsweep::model
