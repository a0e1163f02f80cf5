#pragma once

#include <optional>

#include "rubsweep/core/model/hertz.hpp"

namespace rubsweep::contact {

/// Half-width b in metres of the line contact under `force_n`, with R the relative radius and
/// k = (1 - nu^2) / E of each body: textbook b = sqrt(4 F (k0 + k1) R / (pi L)) (Johnson, Contact Mechanics,
/// 1985, eq. 4.43); paper: Ishibashi & Kawai eq. 11 prints 2 instead of 4, right only if its eq. 12 takes
/// diameters.
double hertz_half_width_m(const model::HertzLine& contact, double force_n);

/// Approach of the two bodies in metres under `force_n`:
/// 2 F (k0 + k1) / (pi L) (2 ln 2 + 1/2 + ln(L / 2b)) (Ishibashi & Kawai eq. 9, after Inagaki et al. 2005):
/// both surfaces in the middle of the strip L x 2b under Hertz's pressure.
double hertz_approach_m(const model::HertzLine& contact, double force_n);

/// Secant stiffness F / approach at the design force, in N/m. Throws ConfigError where the strip would be too
/// wide for its length, so that no approach comes out.
double hertz_stiffness_n_per_m(const model::HertzLine& contact);

/// The secant stiffness of a line contact grows with the logarithm of the force. Up to this force, in
/// newtons, it exceeds the one at the design force by no more than `hertz_secant_tolerance`; beyond it a
/// stiffness that does not depend on the force makes contacts too long and too deep. The closed form is that
/// of the approach: with D = 2 ln 2 + 1/2 + ln(L / 2b) at the design force F, the secant at F' is D / (D -
/// ln(F' / F) / 2) of that at F.
double hertz_force_limit_n(const model::HertzLine& contact);

/// Secant stiffness at another force than the design force; empty where the contact is wider than long under
/// it, so that there is none.
std::optional<double> hertz_secant_n_per_m(const model::HertzLine& contact, double force_n);

inline constexpr double hertz_secant_tolerance = 0.1;

/// Relative radius: 1/R = 1/R_rotor + 1/R_casing for a cylinder, 1/R_rotor for a flat, 1/R_rotor - 1/R_casing
/// in a hole.
double relative_radius_m(const model::HertzLine& contact);

}  // namespace rubsweep::contact
