#pragma once

namespace rubsweep::contact {

/// Damping ratio zeta = d / (2 sqrt(m K)) with which the unclamped oscillator rebounds with `restitution` e
/// in (0, 1]: zeta = |ln e| / sqrt(pi^2 + ln^2 e) (Ishibashi & Kawai eq. 13-14; their eq. 15-16 contradict
/// these).
double nominal_damping_ratio(double restitution);

/// Restitution that the clamped ElastoGap law delivers in one impact of a free mass, for zeta in [0, 1).
/// Closed form over its three pieces: clamped until K p = d v, sprung until K p + d v = 0, then free flight.
double delivered_restitution(double damping_ratio);

/// Inverse of `delivered_restitution`, exact to 1e-15 in the restitution. Throws ConfigError if `restitution`
/// is outside the range of zeta in [0, 1): from e^{-4/3} = 0.2636, the limit at critical damping, to 1.
double damping_ratio_delivering(double restitution);

/// Damping constant d = 2 zeta sqrt(m K), in N s/m. `mass_kg` is the reduced mass of the impact.
double damping_constant(double damping_ratio, double mass_kg, double stiffness_n_per_m);

/// Reduced mass m m_C / (m + m_C), in kg, for an impact with a moving casing.
double reduced_mass(double mass_kg, double casing_mass_kg);

}  // namespace rubsweep::contact
