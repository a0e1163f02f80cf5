#include "rubsweep/diagnose/free_decay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::diagnose {
namespace {

TEST(FreeDecay, EndsAfterTheTurnsThatAreSaid) {
  const int turns = turns_to_decay(30, 0.02, 70, 1e-5);
  const auto left = [](int count) { return std::exp(-0.02 * 2 * std::numbers::pi * 30 * count / 70.0); };
  EXPECT_LE(left(turns), 1e-5);
  EXPECT_GT(left(turns - 1), 1e-5);
}

TEST(FreeDecay, WithoutDampingIsNotWaitedForForever) {
  EXPECT_EQ(turns_to_decay(30, 0, 70, 1e-5), 1'000'000);
}

}  // namespace
}  // namespace rubsweep::diagnose
