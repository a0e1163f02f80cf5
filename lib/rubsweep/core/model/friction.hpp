#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

struct NoFriction {
  static constexpr std::string_view name = "none";

  static void visit_fields(auto&, auto&&) {}
};

/// Dry friction (Coulomb): mu(v) = coefficient for a slip speed v > 0 and -coefficient for v < 0. At v = 0 it
/// is whatever between these two holds the surfaces together, where that does.
struct ConstantFriction {
  static constexpr std::string_view name = "dry";

  double coefficient = required;
  static constexpr Range coefficient_range{.low = 0, .high = 10};

  static void visit_fields(auto& self, auto&& visit) {
    visit("coefficient", self.coefficient,
          key(coefficient_range,
              "dry friction, against the slip; it holds the surfaces together where it can"));
  }
};

/// mu(v) = coefficient whatever the slip speed v, even where v < 0: this friction never changes its
/// direction. A run whose slip would reverse says so in its status.
struct OneWayFriction {
  static constexpr std::string_view name = "one-way";

  double coefficient = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("one_way", self.coefficient,
          newer_key(ConstantFriction::coefficient_range,
                    "friction in the direction of shaft rotation whatever the slip"));
  }
};

/// A friction curve by numbers that can be measured: the largest coefficient and the slip speed where it is
/// reached, the slip speed where the fall behind this peak has ended and the coefficient there (kinetic), and
/// the slope beyond (viscous).
struct StribeckCurve {
  double static_coefficient = required;
  double kinetic = required;
  double peak_speed_m_per_s = required;
  double settle_speed_m_per_s = required;
  double viscous_s_per_m = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("static", self.static_coefficient,
          key(ConstantFriction::coefficient_range, "largest coefficient of a measured curve"));
    visit("kinetic", self.kinetic, key(ConstantFriction::coefficient_range, "coefficient behind the fall"));
    visit("peak_speed_m_per_s", self.peak_speed_m_per_s,
          key(positive, "slip speed of the largest coefficient"));
    visit("settle_speed_m_per_s", self.settle_speed_m_per_s,
          key(positive, "slip speed at which the fall has ended"));
    visit("viscous_s_per_m", self.viscous_s_per_m, key(not_negative, "slope of the coefficient beyond"));
  }
};

/// mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v (Ishibashi & Kawai eq. 17; Makkar et al. 2005).
/// gamma[0..5] = g1 [-], g2 [s/m], g3 [s/m], g4 [-], g5 [s/m], g6 [s/m]; v slip speed in m/s.
struct StribeckFriction {
  static constexpr std::string_view name = "Stribeck";

  std::array<double, 6> gamma{};
  /// Curve that gamma was fitted to (contact::stribeck_of); changes no force.
  std::optional<StribeckCurve> curve = std::nullopt;

  static void visit_fields(auto& self, auto&& visit) {
    for (auto& value : self.gamma) visit("stribeck", value, any_finite);
  }
};

using Friction = std::variant<NoFriction, ConstantFriction, OneWayFriction, StribeckFriction>;

}  // namespace rubsweep::model
