#pragma once

#include <complex>
#include <vector>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// All roots of det(lambda^2 M + lambda Omega C + K0 - Omega^2 K2) = 0 with 50 digits, by simultaneous
/// (Aberth) iteration on the characteristic polynomial, rounded to double at the end. It shares only the
/// assembled matrices with the library.
std::vector<std::complex<double>> roots_with_50_digits(const System& system, double speed_rad_per_s);

/// Real part of (lambda_1 - lambda_2)^2 for the two roots closest to `place`.
double discriminant_with_50_digits(const System& system, double speed_rad_per_s, std::complex<double> place);

/// Number of roots with positive real part, from sign changes in the Routh array of this polynomial; -1 if
/// the array is degenerate.
int routh_hurwitz_with_50_digits(const System& system, double speed_rad_per_s);

/// The same number in long double arithmetic; -1 also where rounding destroys a pivot.
int routh_hurwitz_with_long_double(const System& system, double speed_rad_per_s);

}  // namespace rubsweep::ring
