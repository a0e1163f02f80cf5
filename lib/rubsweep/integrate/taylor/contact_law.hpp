#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/contact/wall.hpp"
#include "rubsweep/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::taylor {

/// mu(slip) = sum over `count` terms of height tanh(steepness slip), plus constant, plus viscous slip.
struct FrictionTerms {
  struct Tanh {
    double height = 0, steepness_s_per_m = 0;
  };
  std::array<Tanh, 3> tanh{};
  std::size_t count = 0;
  double constant = 0;
  double viscous_s_per_m = 0;
};

/// Terms of equal steepness are one, those without effect none.
inline FrictionTerms friction_terms(const model::Friction& friction) {
  FrictionTerms terms;
  if (const auto* constant = std::get_if<model::ConstantFriction>(&friction))
    terms.constant = constant->coefficient;
  if (const auto* stribeck = std::get_if<model::StribeckFriction>(&friction)) {
    const auto& g = stribeck->gamma;
    terms.viscous_s_per_m = g[5];
    const auto add = [&terms](double height, double steepness) {
      if (height == 0 || steepness == 0) return;
      for (std::size_t i = 0; i < terms.count; ++i) {
        if (terms.tanh[i].steepness_s_per_m != steepness) continue;
        terms.tanh[i].height += height;
        return;
      }
      terms.tanh[terms.count++] = {height, steepness};
    };
    add(g[3], g[4]);
    add(g[0], g[1]);
    add(-g[0], g[2]);
  }
  return terms;
}

/// What the power series of a contact's forces take from a scaled contact; none of it depends on the number
/// of coordinates.
struct ContactLaw {
  bool annular = false;
  double clearance = 0, stiffness = 0, damping = 0;
  double slip_scale_m_per_s = 0, surface_speed_m_per_s = 0;
  double mobility = 0;  ///< as ScaledContact
  FrictionTerms friction;

  template <int N>
  explicit ContactLaw(const run::ScaledContact<N>& c)
      : annular(!contact::linear(c.wall)),
        clearance(c.clearance),
        stiffness(c.stiffness),
        damping(c.damping),
        slip_scale_m_per_s(c.slip_scale_m_per_s),
        surface_speed_m_per_s(c.surface_speed_m_per_s),
        mobility(c.mobility()),
        friction(friction_terms(c.friction)) {}

  /// Normal force = spring p + damper p' in a mode.
  double spring(contact::Mode mode) const { return contact::law_of(mode).spring * stiffness; }
  double damper(contact::Mode mode) const { return contact::law_of(mode).damper * damping; }
};

/// From |steepness slip| = 20 on a tanh is one to the last bit. A step that begins there takes it as constant
/// and ends, at the latest, where 19 is reached: 1 - tanh(19) is 6e-17.
inline constexpr double saturated_at_start = 20, saturated_until = 19;

}  // namespace rubsweep::integrate::taylor
