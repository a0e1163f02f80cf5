#pragma once

#include "rubsweep/model/friction.hpp"

namespace rubsweep::contact {

/// Friction coefficient mu at slip speed `slip_m_per_s` (rotor surface relative to the casing, along the
/// tangent). Stribeck: mu(v) = g1 (tanh g2 v - tanh g3 v) + g4 tanh g5 v + g6 v (Ishibashi & Kawai eq. 17),
/// odd in v. Constant: the coefficient, whatever the sign of v.
double friction_coefficient(const model::Friction& friction, double slip_m_per_s);

/// d mu / d v in s/m, for implicit steppers.
double friction_slope(const model::Friction& friction, double slip_m_per_s);

}  // namespace rubsweep::contact
