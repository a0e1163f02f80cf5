#include "rubsweep/analysis/branch/continuation/dip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubsweep::branch::continuation {
namespace {

constexpr double near_zero = 0.5;  ///< share of the end that is nearer to zero

/// a + b t + c t^2 + d t^3 for 0 <= t <= 1.
struct Cubic {
  double a = 0, b = 0, c = 0, d = 0;

  double at(double t) const { return a + t * (b + t * (c + t * d)); }
  double end() const { return a + b + c + d; }
};

struct Extrema {
  std::optional<double> lowest, highest;  ///< places of the local minimum and maximum, where they are inside
};

Extrema extrema_of(const Cubic& f) {
  Extrema found;
  const auto add = [&](double t) {
    if (!(t > 0 && t < 1)) return;
    (f.c + 3 * f.d * t > 0 ? found.lowest : found.highest) = t;
  };
  const double discriminant = f.c * f.c - 3 * f.b * f.d;
  if (!(discriminant > 0)) return found;
  // Both roots of b + 2 c t + 3 d t^2 without a difference of what is nearly equal.
  const double q = -(f.c + std::copysign(std::sqrt(discriminant), f.c));
  if (q != 0) add(f.b / q);
  if (f.d != 0) add(q / (3 * f.d));
  return found;
}

/// Dip of a function that is positive where it begins.
std::optional<double> dip_of(const Cubic& f) {
  const Extrema extrema = extrema_of(f);
  if (!extrema.lowest) return std::nullopt;
  const double lowest = f.at(*extrema.lowest);
  if (f.end() > 0) {
    if (lowest < near_zero * std::min(f.a, f.end())) return extrema.lowest;
    return std::nullopt;
  }
  // Through zero, back, and through it again.
  const bool comes_back =
      extrema.highest && *extrema.highest > *extrema.lowest && f.at(*extrema.highest) > near_zero * f.end();
  if (comes_back && lowest < near_zero * f.a) return extrema.lowest;
  return std::nullopt;
}

std::optional<double> dip_of_signed(Cubic f) {
  if (f.a < 0) f = {-f.a, -f.b, -f.c, -f.d};
  return dip_of(f);
}

}  // namespace

std::optional<double> dip_of_cubic(const StepEnds& ends, double length) {
  const double rise = ends.end - ends.begin, out = length * ends.begin_slope, in = length * ends.end_slope;
  return dip_of_signed({ends.begin, out, 3 * rise - 2 * out - in, out + in - 2 * rise});
}

std::optional<double> dip_of_quadratic(double begin, double end, double mean) {
  return dip_of_signed({begin, 6 * mean - 4 * begin - 2 * end, 3 * (begin + end - 2 * mean), 0});
}

}  // namespace rubsweep::branch::continuation
