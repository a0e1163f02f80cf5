#include "rubsweep/core/numerics/pchip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rubsweep::numerics {
namespace {

double inner_slope(double h_before, double d_before, double h_after, double d_after) {
  if (!(d_before * d_after > 0)) return 0;
  const double w_before = 2 * h_after + h_before, w_after = h_after + 2 * h_before;
  return (w_before + w_after) / (w_before / d_before + w_after / d_after);
}

/// Slope at an end. `h`, `d`: width and secant of the end piece; `h_next`, `d_next`: of its neighbour.
double end_slope(double h, double d, double h_next, double d_next) {
  const double slope = ((2 * h + h_next) * d - h * d_next) / (h + h_next);
  if (!(slope * d > 0)) return 0;
  const bool turns = !(d * d_next > 0);
  return turns && std::abs(slope) > 3 * std::abs(d) ? 3 * d : slope;
}

}  // namespace

Pchip::Pchip(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  const std::size_t n = x_.size();
  slope_.assign(n, 0);
  if (n < 2) return;
  std::vector<double> h(n - 1), d(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x_[i + 1] - x_[i];
    d[i] = (y_[i + 1] - y_[i]) / h[i];
  }
  if (n == 2) {
    slope_.assign(2, d[0]);
    return;
  }
  for (std::size_t i = 1; i + 1 < n; ++i) slope_[i] = inner_slope(h[i - 1], d[i - 1], h[i], d[i]);
  slope_.front() = end_slope(h[0], d[0], h[1], d[1]);
  slope_.back() = end_slope(h[n - 2], d[n - 2], h[n - 3], d[n - 3]);
}

Pchip::Place Pchip::place_of(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto piece = static_cast<std::size_t>(above - x_.begin()) - 1;
  return {piece, std::clamp((x - x_[piece]) / (x_[piece + 1] - x_[piece]), 0.0, 1.0)};
}

double Pchip::operator()(double x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const auto [i, t] = place_of(x);
  if (t == 0) return y_[i];
  const double h = x_[i + 1] - x_[i], rest = 1 - t;
  return rest * rest * ((1 + 2 * t) * y_[i] + t * h * slope_[i]) +
         t * t * ((3 - 2 * t) * y_[i + 1] - rest * h * slope_[i + 1]);
}

double Pchip::slope(double x) const {
  if (x_.size() < 2) return 0;
  const auto [i, t] = place_of(x);
  const double h = x_[i + 1] - x_[i], rest = 1 - t;
  return 6 * t * rest * (y_[i + 1] - y_[i]) / h + rest * (1 - 3 * t) * slope_[i] +
         t * (3 * t - 2) * slope_[i + 1];
}

}  // namespace rubsweep::numerics
