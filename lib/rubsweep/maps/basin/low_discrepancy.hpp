#pragma once

#include <cstddef>
#include <vector>

namespace rubsweep::basin {

/// Most coordinates of a point.
inline constexpr std::size_t most_dimensions = 10;

/// Point `index`, from 0, of Halton's sequence in the open unit cube: the digits of index + 1 mirrored at the
/// point, in the first prime numbers as bases. Any number of first points covers the cube evenly. Throws
/// ConfigError for more than most_dimensions.
std::vector<double> low_discrepancy_point(std::size_t index, std::size_t dimensions);

}  // namespace rubsweep::basin
