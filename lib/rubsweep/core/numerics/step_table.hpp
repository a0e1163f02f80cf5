#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace rubsweep::numerics {

/// Number of steps in a mode's table: sizes 2^(-k/2) of the longest.
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

/// The largest step of the table that is not longer than `size` (in units of the longest, > 0);
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
