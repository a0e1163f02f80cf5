#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "rubsweep/core/model/friction.hpp"

namespace rubsweep::contact {

/// Friction coefficient mu at slip speed v = `slip_m_per_s` (rotor surface relative to the casing, along the
/// tangent). Stribeck: mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v (Ishibashi & Kawai eq. 17),
/// odd in v. Constant: the coefficient with the sign of v; 0 at v = 0, although the law allows any value in
/// between. One-way: the coefficient, independent of the sign of v.
double friction_coefficient(const model::Friction& friction, double slip_m_per_s);

/// Derivative d mu / d v in s/m, for implicit steppers.
double friction_slope(const model::Friction& friction, double slip_m_per_s);

/// Friction whose coefficient no longer depends on the slip speed.
struct SaturatedFriction {
  double coefficient = 0;
  double above_m_per_s = 0;  ///< holds for slip speeds above this; -infinity: for all
};

/// Limit of the friction coefficient at large positive slip speed, and the speed above which it holds. For no
/// friction and a one-way coefficient it holds at every speed, for a constant one at every positive speed.
/// For a Stribeck curve without viscous part (g6 = 0) it holds where every tanh differs from 1 by less than
/// 2e-12; the terms of g1 cancel there. Empty where the coefficient always varies: with a viscous part, or a
/// tanh that never saturates.
std::optional<SaturatedFriction> saturated_friction(const model::Friction& friction);

/// Part of a sliding friction that falls with the slip speed: `height` exp(-(steepness slip)^exponent).
struct Falling {
  double height = 0, steepness_s_per_m = 0;
  int exponent = 1;

  /// Value at a slip speed >= 0, continued smoothly below 0; `slope` is its derivative, in s/m.
  double at(double slip_m_per_s) const;
  double slope(double slip_m_per_s) const;
  /// Steepness of a tanh that saturates at the slip speed at which this part has decayed.
  double saturating_steepness_s_per_m() const { return steepness_s_per_m * (exponent == 1 ? 0.5 : 3.0); }
};

/// Terms of mu(slip), from which its power series is made: the sum of height tanh(steepness slip) over
/// `count` terms, plus constant, plus (dry + falling) sign(slip), plus viscous slip.
struct FrictionTerms {
  struct Tanh {
    double height = 0, steepness_s_per_m = 0;
  };
  std::array<Tanh, 3> tanh{};
  std::size_t count = 0;
  double constant = 0;
  double dry = 0;      ///< coefficient of a set-valued friction at slip zero (contact/dry_friction)
  double holding = 0;  ///< largest friction coefficient at slip zero: >= `dry`
  Falling falling;     ///< added to `dry`, with the same sign as the slip
  double viscous_s_per_m = 0;

  /// Whether the friction drops suddenly as soon as the surfaces slip.
  bool jumps() const { return falling.height == 0 && holding > dry; }
};

/// Terms of a friction law: tanh terms of equal steepness are merged, those without effect left out.
FrictionTerms friction_terms(const model::Friction& friction);

/// Whether there is friction at any slip speed.
bool acts(const model::Friction& friction);

/// Whether the coefficient depends on the slip speed.
bool depends_on_slip(const model::Friction& friction);

/// Whether the friction keeps its direction where the slip reverses. The status of a run reports where this
/// happens.
bool keeps_its_direction(const model::Friction& friction);

/// Coefficient of a set-valued friction at slip zero. Such a friction jumps where the slip reverses, and the
/// surfaces may stick. Zero for other kinds of friction.
double dry_coefficient(const model::Friction& friction);

/// Largest coefficient of such a friction at slip zero, >= the sliding one. Zero for other kinds.
double holding_coefficient(const model::Friction& friction);

/// Kind of friction: "none", "dry", "one-way", "Stribeck", "static and sliding", "falling from static".
std::string_view name_of(const model::Friction& friction);

}  // namespace rubsweep::contact
