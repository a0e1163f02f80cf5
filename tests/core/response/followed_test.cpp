#include "rubsweep/core/response/followed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/response/golden_angle.hpp"

namespace rubsweep::response {
namespace {

/// 400 turns of an angle whose circle shrinks by `decay` a turn, beside a third number that grows by `drift`.
Followed turning(double angle, double decay, double drift = 0) {
  Followed motion{.states = 4, .rows = {}, .contributions = {}};
  for (int k = 0; k < 400; ++k) {
    const double radius = std::exp(-decay * k);
    motion.add(std::array{1 + radius * std::cos(angle * k), radius * std::sin(angle * k), drift * k, 0.0}, 0,
               true);
  }
  return motion;
}

bool like_a_torus(const Followed& motion) {
  spectrum::SpectrumWorkspace workspace;
  return returns_like_a_torus(motion, Eigen::Matrix2d::Identity(), 64, 5e-4, workspace);
}

TEST(Followed, KeepsRowsAndCountsTurnsWithoutContact) {
  Followed motion{.states = 2, .rows = {}, .contributions = {}};
  motion.add(std::array{1.0, 2.0}, 0.5, false);
  motion.add(std::array{3.0, 4.0}, 0.25, false);
  EXPECT_EQ(motion.turns_without_contact, 2);
  motion.add(std::array{5.0, 6.0}, 0.125, true);
  EXPECT_EQ(motion.turns_without_contact, 0);
  EXPECT_EQ(motion.turns(), 3u);
  const auto last = motion.last_rows(2);
  EXPECT_EQ(std::vector<double>(last.begin(), last.end()), (std::vector<double>{3, 4, 5, 6}));
}

TEST(Followed, AnAngleThatNeverComesRoundReturnsLikeATorus) {
  EXPECT_TRUE(like_a_torus(turning(golden_angle, 0)));
  EXPECT_FALSE(like_a_torus(turning(2 * std::numbers::pi / 9, 0)));
  EXPECT_FALSE(like_a_torus(turning(golden_angle, 2e-3)));
}

/// As where nothing dampens the direction along a wall: no disturbance grows, but the motion does.
TEST(Followed, WhatGrowsWithoutAnEndIsNoTorus) {
  EXPECT_TRUE(like_a_torus(turning(golden_angle, 0, 2e-4)));
  EXPECT_FALSE(like_a_torus(turning(golden_angle, 0, 2e-3)));
}

TEST(Followed, AWindowOfAnotherMotionDoesNotBelongToIt) {
  const Followed torus = turning(golden_angle, 0);
  const auto window = [](double radius) {
    std::vector<double> sections;
    for (int k = 0; k < 64; ++k) {
      const double angle = golden_angle * (k - 64.0);
      sections.insert(sections.end(), {1 + radius * std::cos(angle), radius * std::sin(angle), 0.0, 0.0});
    }
    return sections;
  };
  EXPECT_TRUE(belongs_to(torus, window(1)));
  EXPECT_FALSE(belongs_to(torus, window(1.1)));
  EXPECT_FALSE(belongs_to(torus, window(0)));
}

}  // namespace
}  // namespace rubsweep::response
