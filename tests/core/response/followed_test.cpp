#include "rubsweep/core/response/followed.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/response/golden_angle.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::response {
namespace {

/// Rows of a motion that repeats after `period` turns, with a modulation that grows at `rate`.
std::vector<double> modulated(int turns, int period, double modulation, double rate) {
  std::vector<double> rows;
  for (int k = 0; k <= turns; ++k) {
    const double phase = 2 * std::numbers::pi * k / period;
    const double slow = std::numbers::phi * k, size = modulation * std::exp(rate * k);
    rows.push_back(std::cos(phase) + size * std::cos(slow));
    rows.push_back(std::sin(phase) + size * std::sin(slow));
  }
  return rows;
}

TEST(FollowedClosestReturn, OfATorusStays) {
  // A rotation by nu turns returns after n turns within 2 |sin(pi n nu)|: for nu = 13/21 - 1e-3 it is closest
  // at n = 21.
  std::vector<double> rows;
  const double nu = 13.0 / 21 - 1e-3;
  for (int k = 0; k <= 400; ++k) {
    rows.push_back(std::cos(2 * std::numbers::pi * nu * k));
    rows.push_back(std::sin(2 * std::numbers::pi * nu * k));
  }
  const auto nearest = closest_return(rows, 2, 32);
  EXPECT_EQ(nearest.order, 21);
  EXPECT_NEAR(nearest.distance, 2 * std::sin(std::numbers::pi * 0.021), 1e-12);
  EXPECT_NEAR(nearest.rate, 0, 1e-12);
  EXPECT_EQ(closest_return(rows, 2, 20).order, 13);
}

TEST(FollowedClosestReturn, SeesAWeakModulationDieOut) {
  for (const double rate : {-5e-4, -0.02, 7e-4, 0.0}) {
    const auto nearest = closest_return(modulated(512, 6, 1e-3, rate), 2, 32);
    EXPECT_EQ(nearest.order % 6, 0);
    EXPECT_LT(nearest.distance, 4e-3);
    EXPECT_NEAR(nearest.rate, rate, 1e-3 * std::abs(rate) + 1e-12);
    EXPECT_LE(std::abs(nearest.rate - rate), nearest.rate_error_bar + 1e-12);
  }
}

TEST(FollowedClosestReturn, BarIsThatOfALineThroughEightBlocks) {
  // Distances e^y with y = 0 0 0 0 1 1 1 1 over blocks of 8 turns. By hand: slope 8/42 per block, sum of
  // squared residuals 2 - 64/42.
  std::vector<double> rows{0};
  for (int k = 0; k < 64; ++k) rows.push_back(rows.back() + std::exp(k < 32 ? 0 : 1));
  const auto nearest = closest_return(rows, 1, 1);
  const double slope = 8.0 / 42, residual = 2 - 64.0 / 42;
  EXPECT_NEAR(nearest.rate, slope / 8, 1e-12);
  EXPECT_NEAR(nearest.rate_error_bar, 3.707428 * std::sqrt(residual / 6 / 42) / 8, 1e-8);
}

TEST(FollowedClosestReturn, OfAnExactPeriodHasNoRate) {
  std::vector<double> rows;
  for (int k = 0; k <= 100; ++k) rows.push_back(k % 5);
  const auto nearest = closest_return(rows, 1, 12);
  EXPECT_EQ(nearest.order, 5);
  EXPECT_EQ(nearest.distance, 0);
  EXPECT_TRUE(std::isnan(nearest.rate));
}

TEST(FollowedClosestReturn, RefusesRowsThatAreTooFewOrUneven) {
  const std::vector<double> rows(2 * 29);
  EXPECT_NO_THROW(closest_return(rows, 2, 12));
  EXPECT_THROW(closest_return(rows, 2, 13), SolverError);
  EXPECT_THROW(closest_return(rows, 3, 2), SolverError);
  EXPECT_THROW(closest_return(rows, 0, 2), SolverError);
  EXPECT_THROW(closest_return(rows, 2, 0), SolverError);
}

/// 400 turns of a rotation whose circle shrinks by `decay` per turn, with a third number that grows by
/// `drift`.
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

/// Constant drift, as along a wall without damping: no disturbance grows, but the motion does.
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
