#pragma once

#include <complex>
#include <vector>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// All roots of det(lambda^2 M + lambda Omega C + K0 - Omega^2 K2) = 0 with 50 digits, from the
/// characteristic polynomial by simultaneous (Aberth) iteration; rounded to double at the end. Shares with
/// the library only the assembled matrices.
std::vector<std::complex<double>> roots_with_50_digits(const System& system, double speed_rad_per_s);

/// (lambda_1 - lambda_2)^2, its real part, of the two of them nearest to `place`.
double discriminant_with_50_digits(const System& system, double speed_rad_per_s, std::complex<double> place);

/// Number of roots with a positive real part, by the sign changes of the Routh array of that polynomial; -1
/// when the array is degenerate.
int routh_hurwitz_with_50_digits(const System& system, double speed_rad_per_s);

/// The same number by long double arithmetic; -1 also where rounding leaves nothing of a pivot.
int routh_hurwitz_with_long_double(const System& system, double speed_rad_per_s);

}  // namespace rubsweep::ring
