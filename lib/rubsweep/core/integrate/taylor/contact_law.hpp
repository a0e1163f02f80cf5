#pragma once

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::taylor {

/// Parameters of a scaled contact that the power series of its forces use; none depends on the number of
/// coordinates.
struct ContactLaw {
  bool annular = false;
  double clearance = 0, stiffness = 0, damping = 0;
  double slip_scale_m_per_s = 0, surface_speed_m_per_s = 0;
  double mobility = 0;  ///< mobility as in ScaledContact
  contact::FrictionTerms friction;

  template <int N>
  explicit ContactLaw(const run::ScaledContact<N>& c)
      : annular(contact::annular(c.wall)),
        clearance(c.clearance),
        stiffness(c.stiffness),
        damping(c.damping),
        slip_scale_m_per_s(c.slip_scale_m_per_s),
        surface_speed_m_per_s(c.surface_speed_m_per_s),
        mobility(c.mobility()),
        friction(contact::friction_terms(c.friction)) {}

  /// Normal force = spring p + damper p' in this mode.
  double spring(contact::Mode mode) const { return contact::law_of(mode).spring * stiffness; }
  double damper(contact::Mode mode) const { return contact::law_of(mode).damper * damping; }
};

/// At |steepness slip| >= 20 a tanh is 1 to the last bit. A step that starts in this range treats the tanh as
/// constant. It ends, at the latest, at 19, where 1 - tanh(19) is 6e-17.
inline constexpr double saturated_at_start = 20, saturated_until = 19;

}  // namespace rubsweep::integrate::taylor
