#pragma once

#include <algorithm>

namespace rubsweep::numerics {

/// Largest value, over one step, of the cubic with the given values and slopes (per step) at both ends.
double cubic_maximum(double start, double start_slope, double end, double end_slope);

/// Maximum of the cubic or `known`, whichever is larger. The cubic lies below its largest Bernstein
/// coefficient; if this does not exceed `known`, the maximum is not computed.
inline double larger_maximum(double known, double start, double start_slope, double end, double end_slope) {
  const double highest = std::max({start, start + start_slope / 3, end - end_slope / 3, end});
  return highest <= known ? known : std::max(known, cubic_maximum(start, start_slope, end, end_slope));
}

}  // namespace rubsweep::numerics
