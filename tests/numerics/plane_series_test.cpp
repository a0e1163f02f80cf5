#include "rubsweep/numerics/plane_series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rubsweep::numerics {
namespace {

TEST(PlaneSeries, ItsPartsAreWhereTheyAreLookedFor) {
  const Twin pair{3, -5};
  EXPECT_EQ(swapped(pair)[0], -5);
  EXPECT_EQ(swapped(pair)[1], 3);
  EXPECT_EQ(first_twice(pair)[1], 3);
  EXPECT_EQ(second_twice(pair)[0], -5);
  EXPECT_EQ(sum_of(pair)[0], -2);
  EXPECT_EQ(sum_of(pair)[1], -2);
  EXPECT_EQ(sums_of(pair, Twin{10, 20})[0], -2);
  EXPECT_EQ(sums_of(pair, Twin{10, 20})[1], 30);
  EXPECT_EQ(magnitudes(pair)[0], 3);
  EXPECT_EQ(magnitudes(pair)[1], 5);
  // i (3 - 5 i) = 5 + 3 i.
  EXPECT_EQ(quarter_turned(pair)[0], 5);
  EXPECT_EQ(quarter_turned(pair)[1], 3);
  std::array<double, 2> stored{};
  store(stored.data(), pair);
  EXPECT_EQ(stored, (std::array<double, 2>{3, -5}));
}

TEST(Twin, OfReciprocalsAndOfPowers) {
  for (int k = 1; k <= most_taylor_order + 2; ++k) {
    EXPECT_EQ(reciprocal(k)[0], 1.0 / k);
    EXPECT_EQ(reciprocal(k)[1], 1.0 / k);
  }
  for (const int count : {0, 1, 2, 7, 8}) {
    std::array<double, 9> powers;
    powers.fill(-1);
    put_powers(-2, count, powers.data());
    for (int k = 0; k < 9; ++k)
      EXPECT_EQ(powers[static_cast<std::size_t>(k)], k < count ? std::pow(-2, k) : -1) << count << ' ' << k;
  }
}

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
