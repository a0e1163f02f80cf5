#include "rubsweep/core/numerics/plane_series.hpp"

#include <gtest/gtest.h>

namespace rubsweep::numerics {
namespace {

TEST(PlaneSeries, SumsOfEveryLengthAreTheSums) {
  PlaneSeries a, b;
  for (int k = 0; k <= most_taylor_order; ++k) {
    a.set(k, Twin{1.0 + k, 2.0 - k});
    b.set(k, 3.0 * k - 7);
    EXPECT_EQ(b.number(k), 3.0 * k - 7);
  }
  for (int k = 0; k <= most_taylor_order; ++k) {
    for (int first = 0; first <= k; ++first) {
      double along = 0, across = 0;
      for (int j = first; j <= k; ++j) {
        along += (1.0 + j) * (3.0 * (k - j) - 7);
        across += (2.0 - j) * (3.0 * (k - j) - 7);
      }
      EXPECT_EQ(sum_of_products(a, b, k, first, k)[0], along) << k << ' ' << first;
      EXPECT_EQ(sum_of_products(a, b, k, first, k)[1], across) << k << ' ' << first;
      if (first == 0) {
        EXPECT_EQ(product_term(a, b, k)[1], across);
      }
    }
    EXPECT_EQ(sum_of_products(a, b, k, 3, 2)[0], 0);
  }
}

}  // namespace
}  // namespace rubsweep::numerics
