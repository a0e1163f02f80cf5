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

/// Dry friction (Coulomb): mu(v) = coefficient for a slip speed v > 0 and -coefficient for v < 0. At v = 0,
/// mu has the value between these two that holds the surfaces together, if there is one.
struct ConstantFriction {
  static constexpr std::string_view name = "dry";

  double coefficient = required;
  static constexpr Range coefficient_range{.low = 0, .high = 10};

  static void visit_fields(auto& self, auto&& visit) {
    visit("coefficient", self.coefficient,
          key(coefficient_range,
              "dry friction, against the slip; it holds the surfaces together where it can, up to this or up "
              "to "
              "static where that is given"));
  }
};

/// One-way friction: mu(v) = coefficient for every slip speed v, even for v < 0, so that its direction never
/// changes. The status of a run reports where its slip would reverse.
struct OneWayFriction {
  static constexpr std::string_view name = "one-way";

  double coefficient = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("one_way", self.coefficient,
          newer_key(ConstantFriction::coefficient_range,
                    "friction in the direction of shaft rotation whatever the slip"));
  }
};

/// A friction curve given by measurable numbers: the largest coefficient and the slip speed of this peak, the
/// slip speed at which the fall after the peak ends, the coefficient there (kinetic), and the slope beyond
/// (viscous).
struct StribeckCurve {
  double static_coefficient = required;
  double kinetic = required;
  double peak_speed_m_per_s = required;
  double settle_speed_m_per_s = required;
  double viscous_s_per_m = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit(
        "static", self.static_coefficient,
        key(ConstantFriction::coefficient_range,
            "largest coefficient of a measured curve; beside coefficient, bound of the friction that holds"));
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
  /// Curve to which gamma was fitted (contact::stribeck_of); it changes no force.
  std::optional<StribeckCurve> curve = std::nullopt;

  static void visit_fields(auto& self, auto&& visit) {
    for (auto& value : self.gamma) visit("stribeck", value, any_finite);
  }
};

/// Dry friction with a larger static coefficient. At slip zero it holds up to static_coefficient times the
/// spring force; as soon as the surfaces slip, mu(v) = coefficient sign(v).
struct StaticFriction {
  static constexpr std::string_view name = "static and sliding";

  double static_coefficient = required, coefficient = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("static", self.static_coefficient,
          newer_key(ConstantFriction::coefficient_range,
                    "bound of the friction that holds the surfaces together, no less than the sliding one"));
    visit("coefficient", self.coefficient,
          newer_key(ConstantFriction::coefficient_range, "sliding friction, against the slip"));
  }
};

/// Static friction whose sliding coefficient falls from the static one as the slip speed rises (Stribeck's
/// effect):
/// mu(v) = sign(v) (coefficient + (static_coefficient - coefficient) exp(-(|v| / stribeck_speed)^exponent)).
/// Exponents are 1 or 2, because with others the curve has no power series at slip zero.
struct FallingFriction {
  static constexpr std::string_view name = "falling from static";
  static constexpr IntegerRange exponents{.low = 1, .high = 2};

  double static_coefficient = required, coefficient = required, stribeck_speed_m_per_s = required;
  int exponent = 1;

  static void visit_numbers(auto& self, auto&& visit) {
    StaticFriction::visit_fields(self, visit);
    visit("stribeck_speed_m_per_s", self.stribeck_speed_m_per_s,
          newer_key(positive, "slip speed at which exp(-1) of the fall is left"));
  }
  static void visit_fields(auto& self, auto&& visit) {
    visit_numbers(self, visit);
    visit("exponent", self.exponent,
          newer_key(exponents, "power of the slip speed in the exponent of the fall", needed));
  }
};

using Friction = std::variant<NoFriction, ConstantFriction, OneWayFriction, StribeckFriction, StaticFriction,
                              FallingFriction>;

/// Whether this friction can make the surfaces stick.
inline bool may_stick(const Friction& friction) {
  return std::visit(
             [](const auto& law) {
               return requires { law.coefficient; };
             },
             friction) &&
         !std::holds_alternative<OneWayFriction>(friction);
}

/// Static and sliding coefficient of a friction that has both, otherwise zeros.
inline std::array<double, 2> holding_and_sliding(const Friction& friction) {
  return std::visit(
      [](const auto& law) -> std::array<double, 2> {
        if constexpr (requires { law.static_coefficient; }) return {law.static_coefficient, law.coefficient};
        return {};
      },
      friction);
}

}  // namespace rubsweep::model
