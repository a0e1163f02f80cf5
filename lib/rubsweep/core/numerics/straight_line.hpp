#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace rubsweep::numerics {

/// Straight line y = value + slope (x - at).
struct StraightLine {
  double at = 0, value = 0, slope = 0;

  double operator()(double x) const { return value + slope * (x - at); }
};

/// Least-squares line through at least two points whose x are not all equal; `at` is the mean of x.
inline StraightLine line_through(std::span<const double> x, std::span<const double> y) {
  StraightLine line;
  const auto count = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    line.at += x[k] / count;
    line.value += y[k] / count;
  }
  double squares = 0, products = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    squares += (x[k] - line.at) * (x[k] - line.at);
    products += (x[k] - line.at) * (y[k] - line.value);
  }
  line.slope = products / squares;
  return line;
}

/// Largest vertical distance (in y) of a point from the line.
inline double largest_distance(const StraightLine& line, std::span<const double> x,
                               std::span<const double> y) {
  double largest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) largest = std::max(largest, std::abs(y[k] - line(x[k])));
  return largest;
}

}  // namespace rubsweep::numerics
