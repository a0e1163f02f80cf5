#include "rubsweep/core/contact/dry_friction.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace rubsweep::contact {
namespace {

Slip settle_one(double mobility, double acceleration, double limit, double& force) {
  StickMobility a(1, 1);
  StickVector b(1), l(1);
  a << mobility;
  b << acceleration;
  l << limit;
  const SettledSlips settled = settle_slips(a, b, l);
  EXPECT_TRUE(settled.obeys_law);
  force = settled.force(0);
  return settled.slips[0];
}

TEST(DryFriction, OneSurfaceSticksWhereFrictionIsStrongEnough) {
  double force = 0;
  EXPECT_EQ(settle_one(2, 3, 2, force), Slip::sticking);
  EXPECT_EQ(force, 1.5);
  EXPECT_EQ(settle_one(2, 5, 2, force), Slip::forward);
  EXPECT_EQ(force, 2);
  EXPECT_EQ(settle_one(2, -5, 2, force), Slip::backward);
  EXPECT_EQ(force, -2);
}

TEST(DryFriction, WithoutFrictionTheAccelerationDecides) {
  double force = 1;
  EXPECT_EQ(settle_one(2, 3, 0, force), Slip::forward);
  EXPECT_EQ(settle_one(2, -3, 0, force), Slip::backward);
  EXPECT_EQ(force, 0);
}

using Long = long double;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;

/// Minimum of f.Af / 2 - b.f within the box, found by trying every combination of sticking surfaces and
/// surfaces at either limit. `left` is b - A f, the remaining accelerations. For a singular A a minimum
/// exists as well, but f is not unique.
struct BruteForce {
  LongVector left;
  Long least = std::numeric_limits<Long>::infinity();

  BruteForce(const LongMatrix& a, const LongVector& b, const LongVector& limit) {
    const auto n = static_cast<int>(b.size());
    for (int code = 0, all = static_cast<int>(std::pow(3, n)); code < all; ++code) {
      LongVector f(n);
      std::vector<Eigen::Index> free;
      for (int i = 0, rest = code; i < n; ++i, rest /= 3) {
        f(i) = (rest % 3 - 1) * limit(i);
        if (rest % 3 == 1) free.push_back(i);
      }
      if (!free.empty()) {
        const LongMatrix inner = a(free, free);
        const LongVector wanted = (b - a * f)(free);
        const LongVector found = inner.completeOrthogonalDecomposition().solve(wanted);
        if ((inner * found - wanted).cwiseAbs().maxCoeff() > 1e-15L * (1 + wanted.cwiseAbs().maxCoeff()))
          continue;  // no minimum with these surfaces sticking
        f(free) = found;
      }
      if (((f.cwiseAbs() - limit).array() > 1e-14L * (1 + limit.array())).any()) continue;
      const Long value = f.dot(a * f) / 2 - b.dot(f);
      if (value < least) least = value, left = b - a * f;
    }
  }
};

struct Problem {
  StickMobility mobility;
  StickVector acceleration, limit;
};

/// Compares an answer with the friction law and with brute force.
void expect_minimum(const Problem& p, double tolerance, int trial) {
  const SettledSlips settled = settle_slips(p.mobility, p.acceleration, p.limit);
  ASSERT_TRUE(settled.obeys_law) << trial;
  const LongMatrix a = p.mobility.cast<Long>();
  const LongVector b = p.acceleration.cast<Long>(), limit = p.limit.cast<Long>();
  const LongVector f = settled.force.cast<Long>(), left = b - a * f;
  const double size = 1 + p.acceleration.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    EXPECT_LE(std::abs(f(i)), limit(i)) << trial;
    const Slip slip = settled.slips[static_cast<std::size_t>(i)];
    if (slip == Slip::sticking) {
      EXPECT_LT(std::abs(left(i)), 1e-12 * size) << trial;
    } else {
      EXPECT_EQ(f(i), sign_of(slip) * limit(i)) << trial;
      EXPECT_GT(sign_of(slip) * left(i), -1e-12 * size) << trial;
    }
  }
  const BruteForce brute(a, b, limit);
  ASSERT_LT(brute.least, std::numeric_limits<Long>::infinity()) << trial;
  EXPECT_LT((left - brute.left).cwiseAbs().maxCoeff(), tolerance * size) << trial;
  EXPECT_LT(f.dot(a * f) / 2 - b.dot(f) - brute.least, 1e-12 * size * size) << trial;
}

/// Surfaces whose tangent vectors are the columns of a matrix with `rank` rows.
Problem random_problem(std::mt19937& random, int count, int rank) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even;
  StickMobility tangents = StickMobility::NullaryExpr(rank, count, [&] { return normal(random); });
  Problem p;
  p.mobility = tangents.transpose() * tangents;
  p.acceleration = StickVector::NullaryExpr(count, [&] { return normal(random); });
  // Accelerations that come from the motion of one body, so that dependent surfaces can stick together.
  if (even(random) < 0.5)
    p.acceleration = tangents.transpose() * StickVector::NullaryExpr(rank, [&] { return normal(random); });
  p.limit = StickVector::NullaryExpr(count, [&] { return std::abs(normal(random)); });
  if (even(random) < 0.2) p.limit(0) = 0;
  if (even(random) < 0.2) p.limit.setConstant(p.limit(count - 1));
  return p;
}

TEST(DryFriction, AnswersAreThoseOfBruteForce) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 4000; ++trial) {
    const int count = 2 + trial % 4;
    expect_minimum(random_problem(random, count, count), 1e-11, trial);
  }
}

TEST(DryFriction, WithWeakerSlidingFrictionEachSticksThatCanAndTheRestIsPushedOn) {
  std::mt19937 random(11);
  int slipped = 0, followed = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const int count = 1 + trial % 4;
    const Problem p = random_problem(random, count, count);
    const StickVector sliding = p.limit * (0.3 + 0.1 * (trial % 7));
    const StickVector none = StickVector::Zero(count);
    const SettledSlips settled = settle_slips(p.mobility, p.acceleration, none, p.limit, sliding);
    ASSERT_TRUE(settled.obeys_law) << trial;
    const StickVector left = p.acceleration - p.mobility * settled.force;
    const double size = 1e-11 * (1 + p.acceleration.cwiseAbs().maxCoeff());
    int loose = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      const Slip slip = settled.slips[static_cast<std::size_t>(i)];
      if (slip == Slip::sticking) {
        EXPECT_LE(std::abs(settled.force(i)), p.limit(i)) << trial;
        EXPECT_LT(std::abs(left(i)), size) << trial;
      } else {
        EXPECT_EQ(settled.force(i), sign_of(slip) * sliding(i)) << trial;
        EXPECT_GT(sign_of(slip) * left(i), -size) << trial;
        ++loose;
      }
    }
    slipped += loose > 0;
    // With static limits alone fewer surfaces slip: the loss of one surface's static friction makes others
    // slip.
    const SettledSlips held = settle_slips(p.mobility, p.acceleration, p.limit);
    followed +=
        loose > count - std::ranges::count(held.slips.begin(), held.slips.begin() + count, Slip::sticking);
    if (loose == 0) {
      EXPECT_EQ(settled.force, held.force) << trial;
    }
  }
  EXPECT_GT(slipped, 1000);
  EXPECT_GT(followed, 50);
}

TEST(DryFriction, SoAreThoseOfSurfacesMoreThanABodyCanMove) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 4000; ++trial) {
    const int count = 2 + trial % 4;
    expect_minimum(random_problem(random, count, 1 + trial % std::min(count, 3)), 1e-11, trial);
  }
}

/// Flat walls around one rigid rotor; the first tangent has the angle `angles(0)`, in radians.
Problem walls(std::mt19937& random, const std::vector<double>& angles) {
  std::normal_distribution<double> normal;
  const auto count = static_cast<Eigen::Index>(angles.size());
  StickMobility tangents(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = angles[static_cast<std::size_t>(i)];
    tangents.col(i) << std::cos(angle), std::sin(angle);
  }
  Problem p;
  p.mobility = tangents.transpose() * tangents;
  p.acceleration = tangents.transpose() * Eigen::Vector2d(normal(random), 0.1 * normal(random));
  p.limit = StickVector::NullaryExpr(count, [&] { return std::abs(normal(random)); });
  return p;
}

TEST(DryFriction, SoAreThoseOfNearlyParallelTangents) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> even;
  int stuck_together = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const double apart = std::pow(10, -1 - 6.5 * even(random));
    std::vector<double> angles{6.28 * even(random)};
    while (static_cast<int>(angles.size()) < 2 + trial % 3)
      angles.push_back(angles[0] + apart * even(random) + (even(random) < 0.3 ? 3.14159265358979 : 0));
    Problem p = walls(random, angles);
    // Accelerations along the walls, so that two walls can hold them.
    if (trial % 2 == 0)
      p.acceleration =
          p.mobility * StickVector::NullaryExpr(p.limit.size(), [&] { return even(random) - 0.5; });
    // Rounding of A changes the answer by about rounding / angle.
    expect_minimum(p, 1e-11 + 1e-15 / apart, trial);
    const SettledSlips settled = settle_slips(p.mobility, p.acceleration, p.limit);
    stuck_together += std::ranges::count(settled.slips, Slip::sticking) > 1;
  }
  EXPECT_GT(stuck_together, 100);
}

TEST(DryFriction, SixteenSurfacesObeyTheLaw) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 20000; ++trial) {
    const int count = 6 + trial % 11;
    Problem p = random_problem(random, count, 1 + trial % 7);
    if (trial % 3 == 0) p.limit *= 1e-3;
    const SettledSlips settled = settle_slips(p.mobility, p.acceleration, p.limit);
    EXPECT_TRUE(settled.obeys_law) << trial;
  }
}

TEST(DryFriction, EqualWallsThatShareTheLoadHaveAnAnswer) {
  // Ties: all surfaces reach their limits at the same instant.
  for (int count = 2; count <= most_sticking; ++count) {
    const StickMobility a = StickMobility::Constant(count, count, 1);
    for (const double load : {0.0, 0.3, 0.5, 1.0, 1.5, -1.0}) {
      const SettledSlips settled = settle_slips(a, StickVector::Constant(count, load * count * 0.7),
                                                StickVector::Constant(count, 0.7));
      EXPECT_TRUE(settled.obeys_law) << count;
      EXPECT_NEAR(settled.force.sum(), 0.7 * count * std::clamp(load, -1.0, 1.0), 1e-13 * count);
    }
  }
}

TEST(DryFriction, OfTwoWallsOfOneBodyOneSticksAndTheOtherIsPoised) {
  const StickMobility a = StickMobility::Constant(2, 2, 1);
  const SettledSlips settled = settle_slips(a, StickVector::Constant(2, 1), StickVector::Constant(2, 0.7));
  EXPECT_TRUE(settled.obeys_law);
  EXPECT_NEAR(settled.force.sum(), 1, 1e-15);
  const bool first = settled.slips[0] == Slip::sticking;
  EXPECT_NE(first, settled.slips[1] == Slip::sticking);
  EXPECT_TRUE(settled.poised[first ? 1 : 0]);
  EXPECT_FALSE(settled.poised[first ? 0 : 1]);
}

TEST(DryFriction, AnInstantAtWhichTangentsAreParallelLetsOneSlip) {
  // The two slips accelerate at different rates, so both surfaces cannot keep sticking.
  const StickMobility a = StickMobility::Constant(2, 2, 1);
  StickVector b(2);
  b << 1, 1.2;
  const SettledSlips settled = settle_slips(a, b, StickVector::Constant(2, 0.7));
  EXPECT_TRUE(settled.obeys_law);
  EXPECT_EQ(settled.slips[0], Slip::sticking);
  EXPECT_NEAR(settled.force(0), 0.3, 1e-15);
  EXPECT_EQ(settled.slips[1], Slip::forward);
  EXPECT_FALSE(settled.poised[1]);
}

TEST(DryFriction, WhatIsNotFiniteIsNoAnswer) {
  for (const int count : {1, 2, 3}) {
    StickMobility a = StickMobility::Identity(count, count);
    StickVector b = StickVector::Constant(count, 1);
    b(count - 1) = std::nan("");
    EXPECT_FALSE(settle_slips(a, b, StickVector::Constant(count, 0.7)).obeys_law);
  }
}

}  // namespace
}  // namespace rubsweep::contact
