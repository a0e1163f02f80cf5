#include "rubsweep/measurement/diagnose/prior_spread.hpp"

#include <gtest/gtest.h>

namespace rubsweep::diagnose {
namespace {

TEST(PriorSpread, HalfOfTheProbabilityLiesBelowTheMiddle) {
  EXPECT_DOUBLE_EQ(value_at({2, 8, false}, 0.5), 5);
  EXPECT_DOUBLE_EQ(value_at({2, 8, true}, 0.5), 4);
}

TEST(PriorSpread, ReachesFromBoundToBound) {
  for (const bool logarithmic : {false, true}) {
    EXPECT_DOUBLE_EQ(value_at({2, 8, logarithmic}, 0), 2);
    EXPECT_DOUBLE_EQ(value_at({2, 8, logarithmic}, 1), 8);
  }
}

TEST(PriorSpread, OfEqualBoundsIsKnown) { EXPECT_EQ(value_at({0, 0, true}, 0.3), 0); }

}  // namespace
}  // namespace rubsweep::diagnose
