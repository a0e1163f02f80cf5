#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/require.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::model {

/// Formula of the shear coefficient of a section: the mean shear strain is Q / (coefficient G A).
enum class ShearCoefficient {
  cowper,      ///< Cowper, J. Appl. Mech. 33, 1966
  hutchinson,  ///< Hutchinson, J. Appl. Mech. 68, 2001
  none         ///< no shear: cross-sections stay normal to the axis
};
constexpr std::string_view to_string(ShearCoefficient coefficient) { return enumerator_word(coefficient); }

/// Round section and material of a segment of shaft, or of a further layer around or inside it. The ends of a
/// layer move with those of its segment.
struct ShaftLayer {
  double outer_diameter_m = required;
  double inner_diameter_m = 0;
  /// Diameters at the end of the segment; the diameters change linearly from those above. Empty: no taper.
  std::optional<double> outer_diameter_end_m = std::nullopt, inner_diameter_end_m = std::nullopt;
  /// Diameters for bending and shear, where they differ from those for the mass. Empty: the same.
  std::optional<double> stiffness_outer_diameter_m = std::nullopt, stiffness_inner_diameter_m = std::nullopt;
  double youngs_modulus_pa = required;
  double shear_modulus_pa = required;
  double density_kg_per_m3 = required;
  /// Damping matrices of each element, in the fixed frame: its mass times mass_damping_per_s (against motion
  /// in space) plus its stiffness times stiffness_damping_s (against bending).
  double mass_damping_per_s = 0;
  double stiffness_damping_s = 0;
  ShearCoefficient shear_coefficient = ShearCoefficient::cowper;
  bool rotary_inertia = true;
  bool gyroscopic = true;

  static void visit_fields(auto& self, auto&& visit) {
    visit("outer_diameter_m", self.outer_diameter_m, key(physical::diameter_m, "outer diameter"));
    visit("inner_diameter_m", self.inner_diameter_m, key(physical::hole_m, "diameter of the bore"));
    visit("outer_diameter_end_m", self.outer_diameter_end_m,
          key(physical::diameter_m, "outer diameter at the end, to which it changes linearly", "(no taper)"));
    visit("inner_diameter_end_m", self.inner_diameter_end_m,
          key(physical::hole_m, "bore at the end, to which it changes linearly", "(no taper)"));
    visit("stiffness_outer_diameter_m", self.stiffness_outer_diameter_m,
          key(physical::diameter_m,
              "outer diameter that bends and shears, where it is another than that with mass",
              "outer_diameter_m"));
    visit("stiffness_inner_diameter_m", self.stiffness_inner_diameter_m,
          key(physical::hole_m, "bore of the section that bends and shears", "inner_diameter_m"));
    visit("youngs_modulus_pa", self.youngs_modulus_pa, key(physical::modulus_pa, "Young's modulus"));
    visit("shear_modulus_pa", self.shear_modulus_pa, key(physical::modulus_pa, "shear modulus"));
    visit("density_kg_per_m3", self.density_kg_per_m3, key(physical::density_kg_per_m3, "density"));
    visit("mass_damping_per_s", self.mass_damping_per_s,
          key(physical::rate_per_s, "damping against motion in space: this times the mass matrix"));
    visit("stiffness_damping_s", self.stiffness_damping_s,
          key(physical::duration_s,
              "damping against bending: this times the stiffness matrix; it does not turn"));
  }

  /// Keys whose values are words, not numbers.
  static void visit_words(auto& self, auto&& visit) {
    visit(
        "shear_coefficient", self.shear_coefficient,
        newer_key(words_of<ShearCoefficient>(), "formula of the shear coefficient, or a beam without shear"));
    visit("rotary_inertia", self.rotary_inertia,
          newer_key(off_or_on, "inertia of the section against tilting"));
    visit("gyroscopic", self.gyroscopic, newer_key(off_or_on, "gyroscopic moment of the section"));
  }
};

/// Piece of shaft between two stations. Positions along the shaft are measured from the free end of the first
/// segment.
struct ShaftSegment : ShaftLayer {
  double length_m = required;
  /// layers in addition to the segment's own section, over its whole length
  std::vector<ShaftLayer> layers{};

  static void visit_fields(auto& self, auto&& visit) {
    visit("length_m", self.length_m, key(physical::length_m, "length of the segment"));
    ShaftLayer::visit_fields(self, visit);
  }
};

/// Outer and inner diameter of a section.
struct Diameters {
  double outer_m = 0;
  double inner_m = 0;
};

/// Diameters for the mass at the share `at` (0 to 1) of the segment's length.
Diameters diameters(const ShaftLayer& layer, double at);

/// Diameters for bending and shear at the share `at` of the segment's length.
Diameters stiffness_diameters(const ShaftLayer& layer, double at);

/// Whether the diameters change along the segment.
bool is_tapered(const ShaftLayer& layer);

/// Mass of a segment including its layers, in kg.
double mass_kg(const ShaftSegment& segment);

/// Checks diameters that are each in range: the wall thickness must be positive, and a taper must have no
/// separate stiffness diameters. Empty: no problem.
std::optional<PartProblem> diameter_problem(const ShaftLayer& layer);

}  // namespace rubsweep::model
