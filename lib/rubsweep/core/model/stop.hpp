#pragma once

#include <array>
#include <optional>
#include <variant>

#include "rubsweep/core/model/casing.hpp"
#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/model/hertz.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Flat wall whose outward normal (from the rest position towards the wall) stands at `angle_deg`,
/// counted from +x towards +y.
struct OneSideGeometry {
  double angle_deg = required;
};

/// Annular stop, a round hole around the rotor. `offset_m` leads from the centre of the hole to the rotor's
/// rest position, (x, y).
struct AnnularGeometry {
  std::array<double, 2> offset_m{0, 0};
};

using StopGeometry = std::variant<OneSideGeometry, AnnularGeometry>;

/// Sources of the damping constant of a contact; exactly one is given.
struct NominalRestitution {
  double value = required;  ///< e of the unclamped oscillator; the clamp returns more (physics of ElastoGap)
};
/// Nominal restitution with the mass of the rotor alone in d = 2 zeta sqrt(m K), as Ishibashi & Kawai print it (eq. 15).
/// The reduced mass bounces, so that this damps far more against a light casing.
struct RestitutionByRotorMass {
  double value = required;
};
struct DeliveredRestitution {
  double value = required;  ///< e that the clamped law really returns in one free impact
};
struct ExplicitDamping {
  double damping_ns_per_m = required;
};
using ContactDamping = std::variant<NominalRestitution, DeliveredRestitution, ExplicitDamping, RestitutionByRotorMass>;

/// One place where the rotor can touch: geometry, contact law and the casing behind it.
struct Stop {
  StopGeometry geometry;
  std::optional<double> position_m;  ///< along the shaft of a rotor kit; a Jeffcott rotor has none
  double clearance_m =
      required;  ///< C_R: rotor travel to first touch from rest, in an annular stop from its centre
  double stiffness_n_per_m = required;  ///< K of the contact spring
  ContactDamping damping = NominalRestitution{};
  std::optional<double> contact_mass_kg;  ///< mass behind a restitution, before reduction with the casing's;
                                          ///< empty: the Jeffcott mass, or of a kit the modal mass of the
                                          ///< first mode at the stop
  double contact_radius_m = required;     ///< R in the slip speed: rotor surface speed is R omega
  Friction friction = NoFriction{};
  std::optional<Casing> casing;                   ///< empty: rigid
  std::optional<HertzLine> hertz = std::nullopt;  ///< where stiffness_n_per_m came from
                                                  ///< (contact::hertz_stiffness_n_per_m); changes no force

  static constexpr Range restitution_range{.low = 0, .high = 1, .low_open = true};
  /// The clamped law delivers e^{-4/3} = 0.26360 at critical damping and more below it.
  static constexpr Range restitution_delivered_range{.low = 0.2636, .high = 1};

  static void visit_fields(auto& self, auto&& visit) {
    visit("clearance_m", self.clearance_m, positive);
    visit("stiffness_n_per_m", self.stiffness_n_per_m, positive);
    visit("contact_radius_m", self.contact_radius_m, not_negative);
  }
};

}  // namespace rubsweep::model
