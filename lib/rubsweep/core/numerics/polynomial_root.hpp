#pragma once

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

}  // namespace rubsweep::numerics
