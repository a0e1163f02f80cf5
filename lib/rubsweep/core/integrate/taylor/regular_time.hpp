#pragma once

#include <cmath>

#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Relation of a regular time s and the phase: the pace d phase / ds > 0 as a power series of s, up to one
/// order below the highest.
struct RegularTime {
  static constexpr int order = numerics::most_taylor_order, most_iterations = 200;
  numerics::Series pace;
  bool even = false;  ///< the pace is 1 throughout

  double pace_at(double s) const {
    double sum = 0;
    for (int k = order - 1; k >= 0; --k) sum = sum * s + pace[k];
    return sum;
  }
  /// Advance of the phase in radians from s = 0 on.
  double phase_after(double s) const {
    if (even) return s;
    double sum = 0;
    for (int k = order - 1; k >= 0; --k) sum = sum * s + pace[k] * numerics::one_over(k + 1);
    return sum * s;
  }
  /// The s of an advance of the phase, from 0 to `end`: Newton's method within the bounds that it finds.
  double parameter_at(double advance_rad, double end) const {
    if (advance_rad <= 0) return 0;
    if (phase_after(end) <= advance_rad) return end;
    if (even) return advance_rad;
    double low = 0, high = end, s = end;
    for (int k = 0; k < most_iterations && high - low > 1e-16 * end; ++k) {
      const double excess = phase_after(s) - advance_rad;
      if (excess == 0) return s;
      (excess > 0 ? high : low) = s;
      const double next = s - excess / pace_at(s);
      if (std::abs(next - s) <= 1e-16 * end) return s;
      s = next > low && next < high ? next : (low + high) / 2;
    }
    return s;
  }
};

}  // namespace rubsweep::integrate::taylor
