#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace rubsweep::basin {

/// Largest number of dimensions of a point.
inline constexpr std::size_t most_dimensions = 10;

/// Point `index`, from 0, of Halton's sequence in the open unit cube. Coordinates are the digits of index + 1
/// in base 2, 3, 5, ..., mirrored at the decimal point. Any number of first points covers the cube evenly.
/// Throws ConfigError for more than most_dimensions.
std::vector<double> low_discrepancy_point(std::size_t index, std::size_t dimensions);

/// Share of `count` in `samples`, which is > 0.
inline double fraction(std::size_t count, std::size_t samples) {
  return static_cast<double>(count) / static_cast<double>(samples);
}

/// Standard error of a share S found from N independent samples, sqrt(S (1 - S) / N). For points of low
/// discrepancy, which are spread more evenly, it is an upper estimate.
inline double standard_error(double share, std::size_t samples) {
  return std::sqrt(share * (1 - share) / static_cast<double>(samples));
}

}  // namespace rubsweep::basin
