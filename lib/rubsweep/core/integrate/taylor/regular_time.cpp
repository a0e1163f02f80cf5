#include "rubsweep/core/integrate/taylor/regular_time.hpp"

#include <cmath>

namespace rubsweep::integrate::taylor {
namespace {

constexpr int order = numerics::most_taylor_order;
constexpr int most_iterations = 200;

}  // namespace

double RegularTime::pace_at(double s) const {
  double sum = 0;
  for (int k = order - 1; k >= 0; --k) sum = sum * s + pace[k];
  return sum;
}

double RegularTime::phase_after(double s) const {
  double sum = 0;
  for (int k = order - 1; k >= 0; --k) sum = sum * s + pace[k] * numerics::one_over(k + 1);
  return sum * s;
}

/// Newton's method, kept within the bounds that it finds.
double RegularTime::parameter_at(double advance_rad, double end) const {
  if (advance_rad <= 0) return 0;
  if (phase_after(end) <= advance_rad) return end;
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

}  // namespace rubsweep::integrate::taylor
