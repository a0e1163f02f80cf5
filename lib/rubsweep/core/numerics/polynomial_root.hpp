#pragma once

#include <array>
#include <optional>
#include <span>

namespace rubsweep::numerics {

/// Highest degree of a polynomial in this file.
inline constexpr int most_degree = 31;

/// True when one of two cheap tests shows that sum c_k x^k < 0 on all of 0 <= x <= 1. The first test adds c_0
/// and the positive coefficients. The second uses the hull of the cubic part plus the other positive
/// coefficients. False proves nothing.
bool clearly_negative(std::span<const double> coefficients);

/// Smallest x in (0, 1] at which p(x) = sum c_k x^k, at most `most_degree` + 1 coefficients, rises from below
/// zero to zero or above; empty when it never does. Roots are excluded and separated by the signs of
/// Bernstein coefficients (Descartes' rule for an interval: no change of sign, no root; one change, one
/// root), not by sampling. Each root is then found by Halley's iteration, kept inside its interval. The
/// Bernstein form is skipped where p ends above zero and the bounds of p' and p'' show a single root.
///
/// A p that starts above zero must first fall below it. If it starts within `noise` of zero and falls, it
/// counts as starting at zero, and that root is divided out. Roots closer than 2^-44 count as one double
/// root, which is no rise.
std::optional<double> first_rise_of(std::span<const double> coefficients, double noise);

/// Control ordinates of a polynomial of degree 4 over [0, 1] (Bernstein form). The curve lies inside their
/// hull. This can prove that there is no root, where sampling could only suggest it.
using Quartic = std::array<double, 5>;

/// The quartic with the given end values, end slopes (per unit of the interval) and middle value.
Quartic quartic_through(double start, double start_slope, double middle, double end, double end_slope);

/// Whether a cubic with these end values and slopes stays below zero by at least a quarter of its hull's
/// height, so that a guard function with this Hermite interpolant needs no closer search.
bool clearly_below_zero(double start, double start_slope, double end, double end_slope);

/// Smallest argument in (0, 1] at which the quartic rises from below zero to zero or above; empty when it
/// never does. A quartic that starts at or above zero must first fall below zero. Resolution 1e-12.
std::optional<double> bernstein_root(const Quartic& quartic);

}  // namespace rubsweep::numerics
