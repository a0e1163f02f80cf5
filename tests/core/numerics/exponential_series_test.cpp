#include "rubsweep/core/numerics/exponential_series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::numerics {
namespace {

TEST(ExponentialSeries, LeavesOutNothingThatDoubleRoundingShows) {
  for (double size = 1e-6; size <= longest_series; size *= 1.07) {
    const int highest = series_terms(size);
    ASSERT_LT(static_cast<std::size_t>(highest), most_series_terms);
    double left_out = 1;
    for (int k = 1; k <= highest + 1; ++k) left_out *= size / k;
    EXPECT_LT(left_out, 2e-17) << size;
  }
}

TEST(ExponentialSeries, Reciprocals) {
  for (std::size_t k = 1; k < reciprocals.size(); ++k)
    EXPECT_EQ(reciprocals[k], 1 / static_cast<double>(k)) << k;
}

}  // namespace

}  // namespace rubsweep::numerics
