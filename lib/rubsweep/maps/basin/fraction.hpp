#pragma once

#include <cmath>
#include <cstddef>

namespace rubsweep::basin {

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
