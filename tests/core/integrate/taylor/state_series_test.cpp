#include "rubsweep/core/integrate/taylor/state_series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace rubsweep::integrate::taylor {
namespace {

constexpr int series_order = 24;

/// Coordinate i moves as cos(w t) with w = 1 + i: u_k = w^k / k! times 1, 0, -1, 0 in turn.
template <int N>
StateSeries<N> cosines(Eigen::Index coordinates, int up_to = series_order) {
  StateSeries<N> series(coordinates, {.order = up_to});
  std::vector<double> start(static_cast<std::size_t>(2 * coordinates), 0);
  std::fill_n(start.begin(), coordinates, 1.0);
  series.begin(start.data());
  for (int k = 0; k < up_to; ++k) {
    for (Eigen::Index i = 0; i < coordinates; ++i) {
      const double rate = 1 + static_cast<double>(i);
      series.v(k + 1)(i) = -rate * rate * series.u(k)(i) / (k + 1);
      series.u(k + 2)(i) = series.v(k + 1)(i) / (k + 2);
    }
  }
  return series;
}

template <int N>
void expect_cosines(Eigen::Index coordinates, int up_to = series_order) {
  const StateSeries<N> series = cosines<N>(coordinates, up_to);
  std::vector<double> state(static_cast<std::size_t>(2 * coordinates));
  for (const double duration : {0.0, 0.01, 0.4}) {
    series.put_state(duration, state.data());
    for (Eigen::Index i = 0; i < coordinates; ++i) {
      const double rate = 1 + static_cast<double>(i);
      EXPECT_NEAR(state[static_cast<std::size_t>(i)], std::cos(rate * duration), 1e-15);
      EXPECT_NEAR(state[static_cast<std::size_t>(coordinates + i)], -rate * std::sin(rate * duration),
                  rate * 1e-15);
    }
  }
}

TEST(StateSeries, IsTheMotionOfItsCoefficients) {
  expect_cosines<2>(2);
  expect_cosines<4>(4);
  expect_cosines<4>(4, series_order - 1);
  expect_cosines<6>(6);
  expect_cosines<Eigen::Dynamic>(5);
}

/// A sample does not depend on how many samples are evaluated together.
TEST(StateSeries, GivesTheSameBitsForStatesTogetherAndAlone) {
  const StateSeries<4> series = cosines<4>(4);
  constexpr int count = 8;
  std::array<double, 64> together{};
  const auto at = [](int i) { return 0.03 * i; };
  series.put_states(count, at, together.data());
  for (int i = 0; i < count; ++i) {
    std::array<double, 8> alone{};
    series.put_states(
        1, [&](int) { return at(i); }, alone.data());
    for (std::size_t k = 0; k < alone.size(); ++k)
      EXPECT_EQ(together[8 * static_cast<std::size_t>(i) + k], alone[k]);
  }
}

/// For cos(w t) the last two terms w^k t^k / k! are a few units of rounding at this duration. Slightly beyond
/// it one of them is larger, and the sum of all omitted terms is below one unit.
TEST(StateSeries, ConvergesUpToWhereWhatIsLeftOutIsRounding) {
  const StateSeries<2> series = cosines<2>(2);
  const double longest = series.converged_rad(10);
  // The faster coordinate's u' has larger terms relative to its largest speed, which is at most one at the
  // start.
  const double last_even = std::pow(2.0, series_order) / std::tgamma(series_order + 1.0),
               last_odd_rate = 2 * std::pow(2.0, series_order - 1) / std::tgamma(series_order);
  const double expected = std::min(std::pow(0x1p-51 / last_even, 1.0 / series_order),
                                   std::pow(0x1p-51 / last_odd_rate, 1.0 / (series_order - 1)));
  EXPECT_LE(longest, expected);
  EXPECT_GT(longest, 0.999 * expected);
  double left_out = 0;
  for (int k = series_order + 1; k < series_order + 20; ++k)
    left_out += std::pow(2 * longest, k) / std::tgamma(k + 1.0);
  EXPECT_LT(2 * left_out, 0x1p-53);
}

/// For 1 / (1 - t), whose terms decrease only as fast as the radius of convergence allows, the remainder is
/// also rounding.
TEST(StateSeries, LeavesOutNoMoreThanRoundingOfASeriesThatEndsLate) {
  StateSeries<2> series(2, {.order = series_order});
  const std::vector<double> start{1, 1, 1, 1};
  series.begin(start.data());
  for (int k = 1; k <= series_order; ++k) {
    series.v(k).setConstant(k + 1);
    series.u(k + 1).setConstant(1);
  }
  const double longest = series.converged_rad(10);
  double left_out = 0;
  for (int k = series_order + 1; k < series_order + 60; ++k) left_out += (k + 1) * std::pow(longest, k);
  EXPECT_GT(left_out, 0x1p-57);
  EXPECT_LT(left_out, 0x1p-53);
}

/// The last term is proportional to the duration to the power of its order.
TEST(StateSeries, GoesFartherWhereLessAccuracyIsAskedFor) {
  StateSeries<2> rough(2, {.order = series_order, .accuracy = 0x1p-51 * 0x1p24});
  const StateSeries<2> best = cosines<2>(2);
  const std::vector<double> start{1, 1, 0, 0};
  rough.begin(start.data());
  for (int k = 1; k <= series_order; ++k) {
    rough.v(k) = best.v(k);
    rough.u(k + 1) = best.u(k + 1);
  }
  const double longer = rough.converged_rad(10) / best.converged_rad(10);
  EXPECT_GT(longer, 0.99 * std::exp2(24.0 / series_order));
  EXPECT_LT(longer, 1.01 * std::exp2(24.0 / (series_order - 1)));
}

TEST(StateSeries, ConvergesNowhereWhereItIsNotFinite) {
  StateSeries<2> series = cosines<2>(2);
  series.u(series_order)(0) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(series.converged_rad(10), 0);
}

TEST(StateSeries, KnowsItsLargestSpeedAtTheStart) {
  StateSeries<2> series(2, {.order = series_order});
  const std::array<double, 4> start{9, 8, 1, -3};
  series.begin(start.data());
  EXPECT_EQ(series.speed(), 3);
  EXPECT_EQ(series.u(1)(1), -3);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
