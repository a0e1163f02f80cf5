#include "rubsweep/core/numerics/taylor_series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace rubsweep::numerics {
namespace {

TEST(TaylorSeriesRootBelow, IsBelowTheRootByAThousandthAtMost) {
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

TEST(TaylorSeriesRootBelow, IsTheRootOfWhatItDoesNotLookInto) {
  using Limits = std::numeric_limits<double>;
  EXPECT_EQ(root_below(0, 24), 0);
  EXPECT_EQ(root_below(Limits::infinity(), 24), Limits::infinity());
  EXPECT_TRUE(std::isnan(root_below(Limits::quiet_NaN(), 24)));
  EXPECT_EQ(root_below(Limits::denorm_min(), 24), std::pow(Limits::denorm_min(), 1.0 / 24));
  EXPECT_EQ(root_below(9, 2), 3);
}

constexpr int order = most_taylor_order;

double value(const Series& a, double t) {
  double sum = 0;
  for (int k = order; k >= 0; --k) sum = sum * t + a[k];
  return sum;
}

/// Taylor series of cos(w t + start).
Series cosine(double w, double start) {
  Series a;
  double size = 1;
  for (int k = 0; k <= order; size *= w / ++k) a.set(k, size * std::cos(start + k * std::acos(0.0)));
  return a;
}

TEST(TaylorSeries, SquareIsThatOfTheFunction) {
  const Series a = cosine(1.3, 0.4);
  Series square;
  for (int k = 0; k <= order; ++k) square.set(k, square_term(a, k));
  for (const double t : {-0.9, -0.2, 0.0, 0.5, 1.0}) {
    EXPECT_NEAR(value(square, t), std::pow(std::cos(1.3 * t + 0.4), 2), 1e-15);
  }
}

TEST(TaylorSeries, InnerSumsOfEveryLengthAreTheSums) {
  const Series a = cosine(1.7, 0.3), b = cosine(2.3, 1.2);
  for (int k = 0; k <= order; ++k) {
    double sum = 0, square = 0;
    for (int j = 1; j < k; ++j) {
      sum += a[j] * b[k - j];
      square += a[j] * a[k - j];
    }
    EXPECT_NEAR(inner_sum(a, b, k), sum, 1e-14) << k;
    EXPECT_NEAR(inner_square(a, k), square, 1e-14) << k;
  }
}

TEST(TaylorSeriesPower, IsTheProduct) {
  EXPECT_EQ(power(3, 0), 1);
  for (int k = 1; k <= order; ++k) {
    EXPECT_EQ(power(2, k), std::ldexp(1, k));
    EXPECT_NEAR(power(0.7, k), std::pow(0.7, k), 1e-14 * std::pow(0.7, k)) << k;
  }
}

TEST(TaylorSeriesOneOver, IsTheReciprocalOnceAndTwice) {
  for (int k = 1; k <= order + 2; ++k) {
    EXPECT_EQ(one_over(k), 1.0 / k);
    EXPECT_EQ(one_over_twice(k)[0], 1.0 / k);
    EXPECT_EQ(one_over_twice(k)[1], 1.0 / k);
  }
}

TEST(TaylorSeriesPutPowers, WritesAsManyAsAreAskedFor) {
  for (const int count : {0, 1, 2, 7, 8}) {
    std::array<double, 9> powers;
    powers.fill(-1);
    put_powers(-2, count, powers.data());
    for (int k = 0; k < 9; ++k)
      EXPECT_EQ(powers[static_cast<std::size_t>(k)], k < count ? std::pow(-2, k) : -1) << count << ' ' << k;
  }
}

TEST(TaylorSeriesLongestBelow, IsWhereTheTermReachesWhatIsAllowed) {
  EXPECT_EQ(longest_below(0.5, 1, 24, 1e-3), 0.5);  // 0.5^24 = 6e-8
  const double longest = longest_below(2, 1, 24, 1e-3);
  EXPECT_LE(std::pow(longest, 24), 1e-3);
  EXPECT_GT(std::pow(longest * 1.001, 24), 1e-3);
  EXPECT_EQ(longest_below(2, 0, 24, 1e-3), 2);
}

TEST(TaylorSeriesTanh, FollowsTanhOfAMovingArgument) {
  for (const double start : {-3.0, -0.4, 0.0, 1.5, 12.0}) {
    const Series w = cosine(0.8, 0.2);
    TanhSeries tanh;
    for (int k = 0; k <= order; ++k) tanh.add_term(2, k == 0 ? w[0] + start : w[k], k);
    for (const double t : {-0.15, 0.05, 0.2}) {
      const double argument = 2 * (std::cos(0.8 * t + 0.2) + start);
      EXPECT_NEAR(value(tanh.y, t), std::tanh(argument), 2e-15) << start;
      EXPECT_NEAR(value(tanh.z, t), 1 / std::pow(std::cosh(argument), 2), 2e-15) << start;
    }
  }
}

TEST(TaylorSeriesPlaneSeries, SumsOfEveryLengthAreTheSums) {
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
