#pragma once

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::model {

/// One body of a line contact. A flat casing needs no `radius_m`, which then stays NaN.
struct HertzBody {
  double radius_m = required;
  double youngs_modulus_pa = required;
  double poisson_ratio = required;

  static constexpr Range poisson_range{.low = 0, .high = 0.5};

  static void visit_material(auto& self, auto&& visit) {
    visit("youngs_modulus_pa", self.youngs_modulus_pa, key(positive, "Young's modulus"));
    visit("poisson_ratio", self.poisson_ratio, key(poisson_range, "Poisson's ratio"));
  }
};

enum class HertzShape { cylinder, flat, hole };  ///< shape of the casing: convex, plane, or around the rotor
enum class HertzHalfWidth { textbook, paper };   ///< formula for the width of the contact
inline constexpr auto hertz_shapes = words_of<HertzShape>();
inline constexpr auto hertz_half_widths = words_of<HertzHalfWidth>();

/// Contact of two parallel cylinders along a line, from which the contact stiffness is computed.
struct HertzLine {
  double length_m = required;
  HertzBody rotor;
  HertzBody casing;
  HertzShape casing_shape = HertzShape::cylinder;
  double design_force_n = required;  ///< force at which the stiffness is the secant
  HertzHalfWidth half_width = HertzHalfWidth::textbook;

  /// `keys` is the section being read, the printer, or the table of keys (config/keys/table.hpp).
  static void visit_keys(auto& self, auto& keys) {
    keys.field("length_m", self.length_m, key(positive, "length of the contact along the shaft"));
    keys.map("rotor", "surface of the rotor", [&](auto& body) {
      body.field("radius_m", self.rotor.radius_m, key(positive, "radius of the rotor's surface"));
      HertzBody::visit_material(self.rotor, fields_into(body));
    });
    keys.map("casing", "surface of the casing", [&](auto& body) {
      body.field("shape", self.casing_shape, key(hertz_shapes, "shape of the casing's surface"));
      body.beside("shape", {"cylinder", "hole"}, self.casing_shape != HertzShape::flat, [&] {
        body.field("radius_m", self.casing.radius_m, key(positive, "radius of the casing's surface"));
      });
      HertzBody::visit_material(self.casing, fields_into(body));
    });
    keys.field("design_force_n", self.design_force_n,
               key(positive, "force at which the stiffness is the secant"));
    keys.field("half_width", self.half_width, key(hertz_half_widths, "formula of the width of the contact"));
  }
};

}  // namespace rubsweep::model
