#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::taylor {

/// N coordinates in pairs, for expansions that keep their newest terms in registers; empty if N is not a
/// compile-time constant.
template <int N>
struct StatePairs {
  static constexpr std::size_t count = N == Eigen::Dynamic ? 0 : static_cast<std::size_t>(N) / 2;

  StatePairs() = default;
  template <class Vector>
  explicit StatePairs(const Vector& vector) {
    for (std::size_t h = 0; h < count; ++h)
      pairs[h] = numerics::Twin{vector(static_cast<Eigen::Index>(2 * h)),
                                vector(static_cast<Eigen::Index>(2 * h + 1))};
  }
  numerics::Twin& operator[](std::size_t h) { return pairs[h]; }
  numerics::Twin operator[](std::size_t h) const { return pairs[h]; }

  std::array<numerics::Twin, count> pairs;
};

}  // namespace rubsweep::integrate::taylor
