#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubsweep::integrate {

/// First root of g + g' t + M t^2 / 2 for t >= 0, g taken as zero where it is above: as long as |g''| <= M
/// nothing can cross zero before. Infinite where nothing moves.
inline double safe_step(double value, double rate, double curvature_bound) {
  const double gap = std::max(0.0, -value);
  const double root = std::sqrt(rate * rate + 2 * curvature_bound * gap);
  if (rate > 0) return 2 * gap / (rate + root);
  return curvature_bound > 0 ? (root - rate) / curvature_bound : std::numeric_limits<double>::infinity();
}

/// Whether g rises through zero for certain and once: g' > 0 and M |g| <= 0.4 g'^2 (below one half g is
/// monotone up to the crossing).
inline bool crosses(double value, double rate, double curvature_bound) {
  constexpr double reach = 0.4;
  return rate > 0 && curvature_bound * std::max(0.0, -value) <= reach * rate * rate;
}

/// The latest instant of that crossing: root of g + g' t - M t^2 / 2.
inline double latest_crossing(double value, double rate, double curvature_bound) {
  const double gap = std::max(0.0, -value);
  return 2 * gap / (rate + std::sqrt(rate * rate - 2 * curvature_bound * gap));
}

/// Root of g + g' t + g'' t^2 / 2 next to zero: a step of Halley's iteration in its irrational form.
inline double next_root(double value, double rate, double curvature) {
  const double square = rate * rate - 2 * value * curvature;
  return square > 0 ? -2 * value / (rate + std::copysign(std::sqrt(square), rate)) : -value / rate;
}

}  // namespace rubsweep::integrate
