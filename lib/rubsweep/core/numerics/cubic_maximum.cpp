#include "rubsweep/core/numerics/cubic_maximum.hpp"

#include <cmath>

namespace rubsweep::numerics {

double cubic_maximum(double start, double start_slope, double end, double end_slope) {
  // c(x) = start + start_slope x + b x^2 + a x^3 on [0, 1]; inner maximum where c' = 0 and c'' < 0.
  const double a = start_slope + end_slope - 2 * (end - start);
  const double b = 3 * (end - start) - 2 * start_slope - end_slope;
  double largest = std::max(start, end);
  const double discriminant = b * b - 3 * a * start_slope;
  if (discriminant < 0) return largest;
  // The root with c'' = 2 b + 6 a x < 0, in the form without cancellation.
  const double root = std::sqrt(discriminant);
  const double x = b <= 0 ? start_slope / (root - b) : (-b - root) / (3 * a);
  if (x > 0 && x < 1) largest = std::max(largest, start + x * (start_slope + x * (b + x * a)));
  return largest;
}

}  // namespace rubsweep::numerics
