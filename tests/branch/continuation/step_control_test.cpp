#include "rubsweep/branch/continuation/step_control.hpp"

#include <gtest/gtest.h>

#include "rubsweep/branch/continuation/follow.hpp"

namespace rubsweep::branch::continuation {
namespace {

constexpr double straight = 1, gentle = 0.96, sharp = 0.9;

TEST(StepControl, StepsGrowWhereItIsEasyAndShrinkToTheEnd) {
  FollowOptions options;
  options.first_step = 0.1;
  options.longest_step = 0.2;
  options.shortest_step = 1e-3;
  StepControl steps(options);
  steps.lengthen(straight, true);
  EXPECT_DOUBLE_EQ(steps.step(), 0.15);
  steps.lengthen(straight, false);
  steps.lengthen(gentle, true);
  EXPECT_DOUBLE_EQ(steps.step(), 0.15);
  steps.lengthen(straight, true);
  EXPECT_DOUBLE_EQ(steps.step(), 0.2) << "the longest";
  EXPECT_TRUE(steps.turns_sharply(sharp));
  EXPECT_FALSE(steps.turns_sharply(gentle));
  EXPECT_TRUE(steps.is_far(0.05));
  EXPECT_FALSE(steps.is_far(0.03));
  int halves = 1;
  while (steps.shorten()) ++halves;
  EXPECT_EQ(halves, 8) << "0.2 / 2^8 is the first one below 1e-3";
  EXPECT_FALSE(steps.turns_sharply(sharp)) << "so near, a corner is gone round";
}

}  // namespace
}  // namespace rubsweep::branch::continuation
