#include "rubsweep/core/numerics/root_below.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rubsweep::numerics {
namespace {

TEST(RootBelow, IsBelowTheRootByAThousandthAtMost) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int trial = 0; trial < 20000; ++trial) {
    const double x = std::pow(10, exponent(random));
    for (const int k : {16, 22, 23, 24}) {
      const double share = root_below(x, k) / std::pow(x, 1.0 / k);
      ASSERT_LT(share, 1) << x << " " << k;
      ASSERT_GT(share, 1 - 1e-3) << x << " " << k;
    }
  }
}

TEST(RootBelow, IsTheRootOfWhatItDoesNotLookInto) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(root_below(0, 24), 0);
  EXPECT_EQ(root_below(Limits::infinity(), 24), Limits::infinity());
  EXPECT_TRUE(std::isnan(root_below(Limits::quiet_NaN(), 24)));
  EXPECT_EQ(root_below(Limits::denorm_min(), 24), std::pow(Limits::denorm_min(), 1.0 / 24));
  EXPECT_EQ(root_below(9, 2), 3);
}

}  // namespace
}  // namespace rubsweep::numerics
