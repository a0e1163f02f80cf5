#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <variant>

#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/model/hertz.hpp"
#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/normal_law.hpp"
#include "rubsweep/core/model/range.hpp"
#include "rubsweep/core/model/require.hpp"

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

/// Flat wall whose outward normal (from the rest position towards the wall) stands at `angle_deg`,
/// counted from +x towards +y.
struct OneSideGeometry {
  static constexpr std::string_view name = "one_side";

  double angle_deg = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("angle_deg", self.angle_deg,
          key(any_finite, "direction from the rest position to the wall, from +x towards +y"));
  }
  std::optional<PartProblem> problem(double) const { return std::nullopt; }
  double share_of_x() const { return std::pow(std::cos(angle_deg * std::numbers::pi / 180), 2); }
};

/// Annular stop, a round hole around the rotor. `offset_m` leads from the centre of the hole to the rotor's
/// rest position, (x, y).
struct AnnularGeometry {
  static constexpr std::string_view name = "annular";

  std::array<double, 2> offset_m{0, 0};

  static void visit_fields(auto& self, auto&& visit) {
    visit("offset_m", self.offset_m,
          key(NumberPair{}, "[x, y] of the rotor's rest position against the centre of the stop", "[0, 0]"));
  }
  std::optional<PartProblem> problem(double clearance_m) const {
    if (!(std::hypot(offset_m[0], offset_m[1]) >= clearance_m)) return std::nullopt;
    return PartProblem{"offset_m", "the rest position is not inside the annular stop",
                       "a vector shorter than clearance_m"};
  }
  double share_of_x() const { return 0.5; }
};

/// Kinds of stops. Each has its `name` and its keys in a configuration. `problem` judges its numbers together
/// with the clearance of the stop. `share_of_x` is the mean square of the x component of its normals, the
/// weight of plane x where the inverse modal masses of both planes make that of the mass behind the contact.
using StopGeometry = std::variant<OneSideGeometry, AnnularGeometry>;

/// Word of the kind of a stop.
inline std::string_view name_of(const StopGeometry& geometry) {
  return std::visit([](const auto& kind) { return kind.name; }, geometry);
}

inline constexpr Range restitution_range{.low = 0, .high = 1, .low_open = true};

/// The damping constant of a contact comes from exactly one of these sources.
struct NominalRestitution {
  double value = required;  ///< e of the unclamped oscillator; the clamped law rebounds with more

  static void visit_fields(auto& self, auto&& visit) {
    visit("restitution", self.value,
          key(restitution_range, "nominal restitution, from which the damping constant follows"));
  }
};
/// Nominal restitution with the mass of the rotor alone in d = 2 zeta sqrt(m K), as in Ishibashi & Kawai eq.
/// 15. In reality the reduced mass rebounds, so that with a light casing the damping is far too large.
struct RestitutionByRotorMass {
  double value = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("restitution_by_rotor_mass", self.value,
          newer_key(restitution_range, "the same with the mass of the rotor alone in d = 2 zeta sqrt(m K)"));
  }
};
struct DeliveredRestitution {
  double value = required;  ///< e that the clamped law really delivers in a free impact

  /// The clamped law delivers e^{-4/3} = 0.26360 at critical damping and more below it.
  static constexpr Range range{.low = 0.2636, .high = 1};

  static void visit_fields(auto& self, auto&& visit) {
    visit("restitution_delivered", self.value, key(range, "restitution that a free impact really has"));
  }
};
struct ExplicitDamping {
  double damping_ns_per_m = required;

  static void visit_fields(auto& self, auto&& visit) {
    visit("damping_ns_per_m", self.damping_ns_per_m,
          key(not_negative, "damping constant of the contact itself"));
  }
};
using ContactDamping =
    std::variant<NominalRestitution, RestitutionByRotorMass, DeliveredRestitution, ExplicitDamping>;

/// One place where the rotor can touch: geometry, contact law and casing.
struct Stop {
  StopGeometry geometry;
  std::optional<double> position_m;  ///< position along the shaft of a rotor kit; a Jeffcott rotor has none
  double clearance_m =
      required;  ///< C_R: travel of the rotor from rest to first touch, in an annular stop from its centre
  double stiffness_n_per_m = required;  ///< K, stiffness of the contact spring
  ContactDamping damping = NominalRestitution{};
  /// rotor mass for a restitution, before it is reduced with the casing's mass; empty: the mass of a Jeffcott
  /// rotor, or a kit's modal mass of the first mode at the stop
  std::optional<double> contact_mass_kg;
  double contact_radius_m = required;  ///< R in the slip speed: the rotor surface moves with R omega
  Friction friction = NoFriction{};
  std::optional<Casing> casing;                   ///< empty: rigid casing
  std::optional<HertzLine> hertz = std::nullopt;  ///< source of stiffness_n_per_m
                                                  ///< (contact::hertz_stiffness_n_per_m); changes no force
                                                  ///< unless the law is hertz_line
  /// Normal law. If the law is not linear, stiffness_n_per_m is only its secant (contact::secant_n_per_m),
  /// and forces depend neither on this secant nor on `damping`.
  NormalLaw law{};

  /// Whether the stiffness is the secant of `hertz`, valid only near one force.
  bool by_hertz_secant() const { return hertz && law.linear(); }

  static void visit_fields(auto& self, auto&& visit) {
    visit("clearance_m", self.clearance_m,
          key(positive, "travel of the rotor from its unloaded position to the first touch"));
    visit("stiffness_n_per_m", self.stiffness_n_per_m, key(positive, "stiffness of the contact"));
    visit("contact_radius_m", self.contact_radius_m,
          key(not_negative, "radius of the surface that rubs; its speed is this times the shaft speed"));
  }

  /// Keys that follow those of the damping.
  static void visit_mass(auto& self, auto&& visit) {
    visit("contact_mass_kg", self.contact_mass_kg,
          key(positive, "mass behind a restitution, before it is reduced with the casing's",
              "(mass of the Jeffcott rotor, or modal mass of a kit's first mode)"));
  }
};

}  // namespace rubsweep::model
