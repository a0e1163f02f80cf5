#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rubsweep::numerics {

/// Step without a possible crossing, for a guard of value g <= 0 and rate g' whose second derivative stays
/// within |g''| <= M. By Taylor's formula g(t) <= g + g' t + M t^2 / 2; the step is the first root t >= 0 of
/// the right-hand side. A value above zero counts as zero. Infinite where nothing moves.
inline double safe_step(double value, double rate, double curvature_bound) {
  const double gap = std::max(0.0, -value);
  const double root = std::sqrt(rate * rate + 2 * curvature_bound * gap);
  if (rate > 0) return 2 * gap / (rate + root);
  return curvature_bound > 0 ? (root - rate) / curvature_bound : std::numeric_limits<double>::infinity();
}

/// Whether g + g' t + M t^2 / 2 is negative for all 0 <= t <= `duration`.
inline bool stays_below(double value, double rate, double curvature_bound, double duration) {
  return value < 0 && value + duration * (rate + curvature_bound / 2 * duration) < 0;
}

/// Whether g certainly rises through zero exactly once: g' > 0 and M |g| <= 0.4 g'^2 (for a factor below 0.5,
/// g is monotone up to the crossing).
inline bool crosses(double value, double rate, double curvature_bound) {
  constexpr double reach = 0.4;
  return rate > 0 && curvature_bound * std::max(0.0, -value) <= reach * rate * rate;
}

/// Latest possible instant of that crossing: root of g + g' t - M t^2 / 2.
inline double latest_crossing(double value, double rate, double curvature_bound) {
  const double gap = std::max(0.0, -value);
  return 2 * gap / (rate + std::sqrt(rate * rate - 2 * curvature_bound * gap));
}

/// Root of g + g' t + g'' t^2 / 2 nearest to zero: a step of Halley's iteration in its irrational form.
inline double next_root(double value, double rate, double curvature) {
  const double square = rate * rate - 2 * value * curvature;
  return square > 0 ? -2 * value / (rate + std::copysign(std::sqrt(square), rate)) : -value / rate;
}

/// A step of Halley's iteration in its rational form.
inline double halley_step(double value, double slope, double half_curvature) {
  return -value * slope / (slope * slope - value * half_curvature);
}

/// Zero nearest to x = 0 of the series terms[k] x^k, at least three terms, for a function that rises to this
/// zero.
inline double root_of_series(std::span<const double> terms) {
  constexpr int most_iterations = 12;
  constexpr double last_step = 2e-5;  // the cube of such a step is rounding
  double x = halley_step(terms[0], terms[1], terms[2]), last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_iterations; ++i) {
    double value = 0, slope = 0, half_curvature = 0;
    for (std::size_t k = terms.size(); k-- > 0;) {
      half_curvature = half_curvature * x + slope;
      slope = slope * x + value;
      value = value * x + terms[k];
    }
    const double step = halley_step(value, slope, half_curvature);
    if (!(std::abs(step) < last / 2)) break;
    x += step;
    last = std::abs(step);
    if (last < last_step) break;
  }
  return x;
}

}  // namespace rubsweep::numerics
