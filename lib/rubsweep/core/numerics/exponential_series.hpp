#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

namespace rubsweep::numerics {

/// Size |A| t of a step up to which the series of e^{A t} is used.
inline constexpr double longest_series = 1;

/// Size of a step up to which the series, which has 12 terms at this size, costs no more than two steps with
/// the table of flows.
inline constexpr double short_series = 0.14;

/// Order of the last term of the series of e^x, |x| = `size` <= longest_series, above double rounding:
/// size^(n + 1) / (n + 1)! < 2e-17.
inline int series_terms(double size) {
  if (size > 0.74) return 18;
  if (size > 0.49) return 16;
  if (size > 0.29) return 14;
  if (size > 0.14) return 12;
  if (size > 0.057) return 10;
  if (size > 0.013) return 8;
  if (size > 1.1e-3) return 6;
  return size > 1.4e-4 ? 4 : 3;
}

inline constexpr std::size_t most_series_terms = 19;  ///< number of terms, including order zero

/// Rows of a column of Taylor coefficients: an even number, because two are processed at a time; unused rows
/// are zero.
inline constexpr std::size_t series_rows = 20;
template <int columns>
using SeriesTable = Eigen::Matrix<double, static_cast<int>(series_rows), columns>;

/// Table of 1 / k; entry 0 is 0.
inline constexpr auto reciprocals = [] {
  std::array<double, most_series_terms + 1> values{};
  for (std::size_t k = 1; k < values.size(); ++k) values[k] = 1.0 / static_cast<double>(k);
  return values;
}();

/// A column of a SeriesTable, to be multiplied by a factor.
struct SeriesColumn {
  const double* terms;
  double factor;
};

/// terms[k] += factor column[k] for each of `columns` in turn; the number of terms is even.
template <class... Column>
inline void add_terms(std::span<double> terms, const Column&... columns) {
  using Two = Eigen::Array2d;
  assert(terms.size() % 2 == 0);
  for (std::size_t k = 0; k < terms.size(); k += 2) {
    Two sum = Eigen::Map<const Two>(terms.data() + k);
    ((sum += columns.factor * Eigen::Map<const Two>(columns.terms + k)), ...);
    Eigen::Map<Two>(terms.data() + k) = sum;
  }
}

/// terms[k] *= size^k
inline void scale_terms(double size, std::span<double> terms) {
  double power = 1;
  for (double& term : terms) {
    term *= power;
    power *= size;
  }
}

/// Number of steps in a mode's table; the sizes are 2^(-k/2) of the longest.
inline constexpr int exact_step_count = 44;

/// Sizes of the steps in units of the longest.
inline constexpr auto exact_step_sizes = [] {
  std::array<double, exact_step_count> sizes{};
  double size = 1;
  for (std::size_t k = 0; k < sizes.size(); k += 2, size /= 2) {
    sizes[k] = size;
    sizes[k + 1] = size * (std::numbers::sqrt2 / 2);
  }
  return sizes;
}();

inline double exact_step_size(int k) { return exact_step_sizes[static_cast<std::size_t>(k)]; }

/// Index of the largest step in the table that is not longer than `size` (in units of the longest, > 0);
/// exact_step_count when all are longer.
inline int exact_step_below(double size) {
  if (size >= 1) return 0;
  // size = mantissa 2^(exponent - 1023), 1 <= mantissa < 2
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(size) >> 52);
  const int even = 2 * (1023 - exponent);
  if (even > exact_step_count) return exact_step_count;
  return size >= exact_step_size(even - 1) ? even - 1 : even;
}

}  // namespace rubsweep::numerics
