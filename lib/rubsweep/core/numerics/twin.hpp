#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace rubsweep::numerics {

/// Two numbers in one register, which every x86-64 processor has. Wider vectors would be split on processors
/// without wider registers.
using Twin [[gnu::vector_size(16)]] = double;

inline Twin both(double value) { return Twin{value, value}; }
inline Twin swapped(Twin pair) { return __builtin_shufflevector(pair, pair, 1, 0); }
inline Twin first_twice(Twin pair) { return __builtin_shufflevector(pair, pair, 0, 0); }
inline Twin second_twice(Twin pair) { return __builtin_shufflevector(pair, pair, 1, 1); }
/// Absolute values, by clearing the sign bits in one instruction.
inline Twin magnitudes(Twin pair) {
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
  constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
  return std::bit_cast<Twin>(std::bit_cast<Bits>(pair) & Bits{all_but_sign, all_but_sign});
}
/// Sum of both numbers, in both places.
inline Twin sum_of(Twin pair) { return pair + swapped(pair); }
/// Pair of the sum of `first` and the sum of `second`.
inline Twin sums_of(Twin first, Twin second) {
  return __builtin_shufflevector(first, second, 0, 2) + __builtin_shufflevector(first, second, 1, 3);
}
inline Twin larger(Twin one, Twin other) { return one < other ? other : one; }
inline Twin smaller(Twin one, Twin other) { return other < one ? other : one; }
inline Twin load(const double* from) {
  Twin pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
inline void store(double* to, Twin pair) { std::memcpy(to, &pair, sizeof pair); }
/// Vector turned by a quarter turn: (-y, x).
inline Twin quarter_turned(Twin pair) { return Twin{-1, 1} * swapped(pair); }

}  // namespace rubsweep::numerics
