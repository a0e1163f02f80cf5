#include "rubsweep/core/integrate/taylor/regular_time.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::integrate::taylor {
namespace {

/// The pace c + s, whose advance is c s + s^2 / 2.
RegularTime growing_from(double c) {
  RegularTime time;
  for (int k = 0; k <= numerics::most_taylor_order; ++k) time.pace.set(k, k == 0 ? c : k == 1 ? 1 : 0);
  return time;
}

TEST(RegularTime, AdvancesByTheIntegralOfThePace) {
  const RegularTime time = growing_from(2);
  EXPECT_NEAR(time.phase_after(3), 2 * 3 + 4.5, 1e-14);
  EXPECT_NEAR(time.pace_at(3), 5, 1e-15);
}

TEST(RegularTime, FindsTheParameterOfAnAdvanceAlsoWhereThePaceIsZero) {
  for (const double c : {0.0, 1e-9, 1.0}) {
    const RegularTime time = growing_from(c);
    for (const double advance : {1e-20, 1e-6, 0.3, 0.49})
      EXPECT_NEAR(time.parameter_at(advance, 1), 2 * advance / (c + std::sqrt(c * c + 2 * advance)), 4e-16)
          << c << ' ' << advance;
  }
  const RegularTime time = growing_from(0);
  EXPECT_EQ(time.parameter_at(0, 1), 0);
  EXPECT_EQ(time.parameter_at(0.5, 1), 1);
  EXPECT_EQ(time.parameter_at(2, 1), 1) << "beyond the end";
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
