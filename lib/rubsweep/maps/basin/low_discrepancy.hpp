#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace rubsweep::basin {

/// Most coordinates of a point.
inline constexpr std::size_t most_dimensions = 10;

/// Point `index`, from 0, of Halton's sequence in the open unit cube: the digits of index + 1 mirrored at the
/// point, in the first prime numbers as bases. Any number of first points covers the cube evenly. Throws
/// ConfigError for more than most_dimensions.
std::vector<double> low_discrepancy_point(std::size_t index, std::size_t dimensions);

/// Share of `samples` > 0 that `count` of them are.
inline double fraction(std::size_t count, std::size_t samples) {
  return static_cast<double>(count) / static_cast<double>(samples);
}

/// Standard error of a share S found from N independent samples, sqrt(S (1 - S) / N). Points of low
/// discrepancy spread more evenly than independent ones: for them it is an upper estimate.
inline double standard_error(double share, std::size_t samples) {
  return std::sqrt(share * (1 - share) / static_cast<double>(samples));
}

}  // namespace rubsweep::basin
