#include "rubsweep/core/response/closest_return.hpp"

#include <fmt/format.h>

#include <boost/math/statistics/linear_regression.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/lyapunov_exponent.hpp"

namespace rubsweep::response {
namespace {

constexpr std::size_t trend_blocks = 8;

/// Squared distance of every row from the one `order` turns later.
void square_distances(std::span<const double> rows, std::size_t width, std::size_t order,
                      std::vector<double>& squares) {
  squares.clear();
  const std::size_t lag = order * width;
  for (std::size_t first = 0; first + lag < rows.size(); first += width) {
    double square = 0;
    for (std::size_t i = first; i < first + width; ++i) {
      square += (rows[i + lag] - rows[i]) * (rows[i + lag] - rows[i]);
    }
    squares.push_back(square);
  }
}

double mean(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Slope of ln distance per turn, with its error bar.
void fit_rate(std::span<const double> squares, ClosestReturn& result) {
  const std::size_t length = squares.size() / trend_blocks;
  const auto kept = squares.last(trend_blocks * length);
  std::vector<double> places, logs;
  for (std::size_t b = 0; b < trend_blocks; ++b) {
    places.push_back(static_cast<double>(b) - (trend_blocks - 1) / 2.0);
    logs.push_back(std::log(mean(kept.subspan(b * length, length))) / 2);
  }
  const auto [level, slope] = boost::math::statistics::simple_ordinary_least_squares(places, logs);
  double residual = 0, spread = 0;
  for (std::size_t b = 0; b < trend_blocks; ++b) {
    const double error = logs[b] - level - slope * places[b];
    residual += error * error / (trend_blocks - 2);
    spread += places[b] * places[b];
  }
  result.rate = slope / static_cast<double>(length);
  result.rate_error_bar =
      student_quantile(trend_blocks - 2) * std::sqrt(residual / spread) / static_cast<double>(length);
}

}  // namespace

ClosestReturn closest_return(std::span<const double> rows, int states, int max_order) {
  const auto width = static_cast<std::size_t>(states);
  if (states < 1 || max_order < 1 || rows.size() % width != 0 ||
      rows.size() / width < static_cast<std::size_t>(max_order) + 2 * trend_blocks + 1) {
    throw SolverError(fmt::format("{} numbers are no section of {} states for returns up to {} turns",
                                  rows.size(), states, max_order));
  }
  ClosestReturn result;
  double smallest = std::numeric_limits<double>::infinity();
  std::vector<double> squares, nearest;
  for (int n = 1; n <= max_order; ++n) {
    square_distances(rows, width, static_cast<std::size_t>(n), squares);
    const double square = mean(squares);
    if (!(square < smallest)) continue;
    smallest = square;
    result.order = n;
    nearest.swap(squares);
  }
  result.distance = std::sqrt(smallest);
  fit_rate(nearest, result);
  return result;
}

}  // namespace rubsweep::response
