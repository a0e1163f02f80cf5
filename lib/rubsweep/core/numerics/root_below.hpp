#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rubsweep::numerics {

/// The k-th root of x > 0, or up to a thousandth of it less: enough for the length of a step, in a quarter of
/// std::pow's time. With x = 2^e (1 + f), polynomials approximate log2(1 + f) and the power of two; low roots
/// and subnormal numbers are left to std::pow.
inline double root_below(double x, int k) {
  constexpr int least_root = 16, digits = 52, bias = 1023;
  using Limits = std::numeric_limits<double>;
  if (k < least_root || !(x >= Limits::min() && x <= Limits::max())) return std::pow(x, 1.0 / k);
  constexpr auto one = std::uint64_t{bias} << digits, fraction = (std::uint64_t{1} << digits) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const double f = std::bit_cast<double>((bits & fraction) | one) - 1;
  // Within 0.01, of which the root keeps a k-th part; `bias` is added to be above zero, where the whole part
  // is what a conversion leaves.
  const double logarithm = (static_cast<int>(bits >> digits) - bias + f * (4 - f) / 3) / k + bias;
  const auto whole = static_cast<std::uint64_t>(static_cast<std::int64_t>(logarithm));
  const double g = logarithm - static_cast<double>(static_cast<std::int64_t>(whole));
  // Relative error below 1.5e-4.
  const double power = 1 + g * (0.695976 + g * (0.224940 + g * 0.079084));
  constexpr double below = 1 - 4.5e-4;
  return below * power * std::bit_cast<double>(whole << digits);
}

}  // namespace rubsweep::numerics
