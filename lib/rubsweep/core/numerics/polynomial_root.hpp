#pragma once

#include <array>
#include <optional>
#include <span>

namespace rubsweep::numerics {

/// Highest degree of a polynomial here.
inline constexpr int most_degree = 31;

/// True when sum c_k x^k < 0 on all of 0 <= x <= 1 by one of two cheap tests: c_0 and the positive
/// coefficients together are below zero, or the hull of the cubic part and the positive rest are. False says
/// nothing.
bool clearly_negative(std::span<const double> coefficients);

/// Smallest x in (0, 1] at which p(x) = sum c_k x^k, at most `most_degree` + 1 coefficients, rises from below
/// zero to zero or above; empty when it never does. Roots are excluded and told apart by the signs of
/// Bernstein coefficients (Descartes' rule for an interval: no change of sign, no root; one change, one
/// root), not by sampling, and a root is then found by Halley's iteration kept inside its interval. Where p
/// ends above zero and rises all the way or bends one way only, as the same bounds say of p' and p'', it has
/// one root without that form.
///
/// A p that starts above zero must first fall below. One that starts within `noise` of zero and falls counts
/// as starting at zero: that root is divided out. Two roots nearer to each other than 2^-44 are not told from
/// a double one, which is no rise.
std::optional<double> first_rise_of(std::span<const double> coefficients, double noise);

/// Control ordinates of a polynomial of degree 4 over [0, 1] (Bernstein form): the curve stays inside their
/// hull, which turns "no root here" from a guess by sampling into a proof.
using Quartic = std::array<double, 5>;

/// The quartic with the given end values, end slopes (per unit of the interval) and middle value.
Quartic quartic_through(double start, double start_slope, double middle, double end, double end_slope);

/// True when a cubic with these end values and slopes clears zero from below by a quarter of its hull's
/// height, so that a guard function with this cubic Hermite interpolant needs no closer look.
bool clearly_below_zero(double start, double start_slope, double end, double end_slope);

/// Smallest argument in (0, 1] at which the quartic rises from below zero to zero or above; empty when it
/// never does. A quartic that starts at or above zero must first fall below. Resolution 1e-12.
std::optional<double> bernstein_root(const Quartic& quartic);

}  // namespace rubsweep::numerics
