#pragma once

#include <span>

namespace rubsweep::response {

/// How near a once-per-turn section comes to returning.
struct ClosestReturn {
  int order = 0;        ///< n of the smallest mean square distance between rows n turns apart
  double distance = 0;  ///< root of that mean square, in the unit of the rows
  double rate = 0;      ///< at which the distance grows, per turn; negative: the motion is still settling
  double rate_error_bar = 0;  ///< half-width of the 99 % confidence interval of `rate`
};

/// Nearest return over all orders 1..max_order. `rows` as `period_of_section` takes them. On a torus the
/// distance stays, towards a periodic motion it decays at the rate of the slowest multiplier, whatever else
/// moves: it shows a weak modulation that dies out long before the exponent does. The rate is the slope of
/// ln(distance) over 8 successive blocks by least squares, its bar t s(slope) with t = 3.7074 (Student, 6
/// degrees of freedom); both are NaN when a block returns exactly. SolverError when `rows` has no such shape
/// or fewer than max_order + 16 turns.
ClosestReturn closest_return(std::span<const double> rows, int states, int max_order);

}  // namespace rubsweep::response
