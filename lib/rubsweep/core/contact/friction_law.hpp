#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "rubsweep/core/model/friction.hpp"

namespace rubsweep::contact {

/// Friction coefficient mu at slip speed `slip_m_per_s` (rotor surface relative to the casing, along the
/// tangent). Stribeck: mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v (Ishibashi & Kawai eq. 17),
/// odd in v. Constant: the coefficient with the sign of v; zero at v = 0, where it stands for all between.
/// One-way: the coefficient, whatever the sign of v.
double friction_coefficient(const model::Friction& friction, double slip_m_per_s);

/// d mu / d v in s/m, for implicit steppers.
double friction_slope(const model::Friction& friction, double slip_m_per_s);

/// Friction whose coefficient no longer depends on the slip speed.
struct SaturatedFriction {
  double coefficient = 0;
  double above_m_per_s = 0;  ///< holds for slip speeds above this; -infinity: for all
};

/// The limit of `friction` at large positive slip: no friction and a one-way coefficient at every speed, a
/// constant one at every positive speed; a Stribeck curve without viscous part (g6 = 0) where every tanh
/// differs from 1 by less than 2e-12, g1's pair cancelling. Empty for a viscous part or a tanh that never
/// saturates: then the coefficient always varies.
std::optional<SaturatedFriction> saturated_friction(const model::Friction& friction);

/// Part of a sliding friction that falls with the slip, exp(-(steepness slip)^exponent) of `height`.
struct Falling {
  double height = 0, steepness_s_per_m = 0;
  int exponent = 1;

  /// At a slip >= 0 in its own direction, continued smoothly below; and the derivative by it.
  double at(double slip_m_per_s) const;
  double slope(double slip_m_per_s) const;
  /// Steepness of a tanh that saturates where this has ended.
  double saturating_steepness_s_per_m() const { return steepness_s_per_m * (exponent == 1 ? 0.5 : 3.0); }
};

/// mu(slip) = sum over `count` terms of height tanh(steepness slip), plus constant, plus (dry + falling)
/// sign(slip), plus viscous slip: the terms that its power series is made of.
struct FrictionTerms {
  struct Tanh {
    double height = 0, steepness_s_per_m = 0;
  };
  std::array<Tanh, 3> tanh{};
  std::size_t count = 0;
  double constant = 0;
  double dry = 0;      ///< coefficient of a friction that is a set at slip zero (contact/dry_friction)
  double holding = 0;  ///< bound of that set: `dry`, or more
  Falling falling;     ///< beside `dry`, and as it in the direction of the slip
  double viscous_s_per_m = 0;

  /// The friction is less as soon as the surfaces slip.
  bool jumps() const { return falling.height == 0 && holding > dry; }
};

/// Terms of equal steepness are one, those without effect none.
FrictionTerms friction_terms(const model::Friction& friction);

/// Whether there is any, at some slip.
bool acts(const model::Friction& friction);

/// Whether the coefficient depends on the slip speed.
bool depends_on_slip(const model::Friction& friction);

/// Whether the friction would go on in its old direction where the slip reverses. A run in which that happens
/// says so in its status.
bool keeps_its_direction(const model::Friction& friction);

/// Coefficient of a friction that is a set at slip zero: it jumps where the slip reverses, and may hold the
/// surfaces together. Zero where there is none.
double dry_coefficient(const model::Friction& friction);

/// Bound of such a friction where the slip is zero: no less than it slips with. Zero where there is none.
double holding_coefficient(const model::Friction& friction);

/// "none", "dry", "one-way", "Stribeck", "static and sliding", "falling from static".
std::string_view name_of(const model::Friction& friction);

}  // namespace rubsweep::contact
