#include "rubsweep/core/numerics/cubic_maximum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rubsweep::numerics {
namespace {

TEST(CubicMaximum, AgreesWithFineSampling) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int inner = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double c0 = normal(random), c1 = normal(random), c2 = normal(random),
                 c3 = trial % 5 ? normal(random) : 0;
    const auto cubic = [&](double x) { return c0 + x * (c1 + x * (c2 + x * c3)); };
    double sampled = cubic(0);
    for (int i = 1; i <= 2000; ++i) sampled = std::max(sampled, cubic(i / 2000.0));
    const double largest = cubic_maximum(c0, c1, cubic(1), c1 + 2 * c2 + 3 * c3);
    EXPECT_NEAR(largest, sampled, 1e-5) << trial;
    EXPECT_GE(largest, sampled - 1e-12);
    if (largest > std::max(cubic(0), cubic(1)) + 1e-9) ++inner;
  }
  EXPECT_GT(inner, 100);
}

/// With a known lower bound, the search may be skipped only where the cubic stays below the bound.
TEST(CubicMaximum, IsTakenWhereItIsLargerThanWhatIsKnown) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  int larger = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double start = normal(random), start_slope = 3 * normal(random), end = normal(random),
                 end_slope = 3 * normal(random), known = normal(random);
    const double largest = cubic_maximum(start, start_slope, end, end_slope);
    EXPECT_EQ(larger_maximum(known, start, start_slope, end, end_slope), std::max(known, largest));
    if (largest > known) ++larger;
  }
  EXPECT_GT(larger, 100);
}

TEST(CubicMaximum, OfAConstantIsTheConstant) { EXPECT_EQ(cubic_maximum(2, 0, 2, 0), 2); }

}  // namespace
}  // namespace rubsweep::numerics
