#include "rubsweep/core/model/range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/model/infinity.hpp"

namespace rubsweep::model {
namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();

TEST(RangeContains, ClosedEndsBelongToTheIntervalOpenEndsDoNot) {
  const Range closed{.low = 1, .high = 3}, open{.low = 1, .high = 3, .low_open = true, .high_open = true};
  EXPECT_TRUE(contains(closed, 1));
  EXPECT_TRUE(contains(closed, 3));
  EXPECT_FALSE(contains(open, 1));
  EXPECT_FALSE(contains(open, 3));
  for (const Range& range : {closed, open}) {
    EXPECT_TRUE(contains(range, std::nextafter(1.0, 2.0)));
    EXPECT_TRUE(contains(range, std::nextafter(3.0, 2.0)));
    EXPECT_FALSE(contains(range, std::nextafter(1.0, 0.0)));
    EXPECT_FALSE(contains(range, std::nextafter(3.0, 4.0)));
  }
}

TEST(RangeContains, EveryEndIsOptional) {
  EXPECT_TRUE(contains(any_finite, -1e30));
  EXPECT_TRUE(contains(any_finite, 1e30));
  EXPECT_TRUE(contains(Range{.high = 2}, -1e30));
  EXPECT_FALSE(contains(Range{.high = 2}, 2.1));
}

TEST(RangeContains, NoMagnitudeOfWhichProductsAreNoNumbers) {
  EXPECT_TRUE(contains(positive, 1e-30));
  for (const double value : {1e-300, 9e-31, 1.1e30, 1e308, smallest}) {
    EXPECT_FALSE(contains(positive, value)) << value;
    EXPECT_FALSE(contains(any_finite, -value)) << value;
    EXPECT_EQ(describe(positive, value), "1e-30 to 1e+30 in magnitude");
    EXPECT_EQ(describe(not_negative, value), "0, or 1e-30 to 1e+30 in magnitude");
    EXPECT_EQ(describe(positive, -value), "a number > 0");
  }
}

TEST(RangeContains, PositiveLeavesOutBothZeros) {
  EXPECT_TRUE(contains(positive, smallest_magnitude));
  EXPECT_FALSE(contains(positive, 0.0));
  EXPECT_FALSE(contains(positive, -0.0));
  EXPECT_TRUE(contains(not_negative, 0.0));
  EXPECT_TRUE(contains(not_negative, -0.0));
  EXPECT_FALSE(contains(not_negative, -smallest));
}

TEST(RangeContains, NothingThatIsNotFinite) {
  for (const Range& range : {any_finite, positive, not_negative, Range{.low = -infinity, .high = infinity}}) {
    EXPECT_FALSE(contains(range, infinity));
    EXPECT_FALSE(contains(range, -infinity));
    EXPECT_FALSE(contains(range, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(contains(range, required));
  }
}

TEST(RangeDescribe, FinishesTheWordsAllowed) {
  EXPECT_EQ(describe(any_finite), "a finite number");
  EXPECT_EQ(describe(positive), "a number > 0");
  EXPECT_EQ(describe(not_negative), "a number >= 0");
  EXPECT_EQ(describe(Range{.high = 2.5}), "a number <= 2.5");
  EXPECT_EQ(describe(Range{.high = -1, .high_open = true}), "a number < -1");
  EXPECT_EQ(describe(Range{.low = 0, .high = 1}), "a number >= 0 and <= 1");
  EXPECT_EQ(describe(Range{.low = 0, .high = 1, .low_open = true}), "a number > 0 and <= 1");
  EXPECT_EQ(describe(Range{.low = 1e-14, .high = 1e-2, .low_open = true, .high_open = true}),
            "a number > 1e-14 and < 0.01");
}

}  // namespace
}  // namespace rubsweep::model
