#pragma once

#include <optional>

#include "rubsweep/core/model/hertz.hpp"

namespace rubsweep::contact {

/// Half-width b in metres of the line contact under `force_n`, with R the relative radius and k = (1 - nu^2)
/// / E of each body. Textbook: b = sqrt(4 F (k0 + k1) R / (pi L)) (Johnson, Contact Mechanics, 1985, eq.
/// 4.43). Paper: Ishibashi & Kawai eq. 11 has 2 instead of 4, which is right only if their eq. 12 takes
/// diameters.
double hertz_half_width_m(const model::HertzLine& contact, double force_n);

/// Approach of the two bodies in metres under `force_n`:
/// 2 F (k0 + k1) / (pi L) (2 ln 2 + 1/2 + ln(L / 2b)) (Ishibashi & Kawai eq. 9, after Inagaki et al. 2005).
/// It is the displacement of both surfaces in the middle of the strip L x 2b under Hertz's pressure.
double hertz_approach_m(const model::HertzLine& contact, double force_n);

/// Secant stiffness F / approach at the design force, in N/m. Throws ConfigError where the contact strip is
/// too wide for its length, so that the formula gives no positive approach.
double hertz_stiffness_n_per_m(const model::HertzLine& contact);

/// Force, in newtons, up to which the secant stiffness exceeds its value at the design force by at most
/// `hertz_secant_tolerance`. The secant grows with the logarithm of the force; beyond this limit a constant
/// stiffness makes contacts too long and too deep. Closed form: with D = 2 ln 2 + 1/2 + ln(L / 2b) at the
/// design force F, the secant at F' is D / (D - ln(F' / F) / 2) times that at F.
double hertz_force_limit_n(const model::HertzLine& contact);

/// Secant stiffness (N/m) at a force other than the design force; empty where this force makes the contact
/// wider than its length.
std::optional<double> hertz_secant_n_per_m(const model::HertzLine& contact, double force_n);

inline constexpr double hertz_secant_tolerance = 0.1;

/// Relative radius R in metres: 1/R = 1/R_rotor + 1/R_casing for a cylinder, 1/R_rotor for a flat casing,
/// 1/R_rotor - 1/R_casing in a hole.
double relative_radius_m(const model::HertzLine& contact);

}  // namespace rubsweep::contact
