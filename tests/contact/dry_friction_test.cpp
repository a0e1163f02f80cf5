#include "rubsweep/contact/dry_friction.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace rubsweep::contact {
namespace {

Slip settle_one(double mobility, double acceleration, double limit, double& force) {
  Slip slip = Slip::sticking;
  StickMobility a(1, 1);
  StickVector b(1), l(1), f;
  a << mobility;
  b << acceleration;
  l << limit;
  settle_slips(a, b, l, &slip, f);
  force = f(0);
  return slip;
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

/// Largest violation of the law by what `settle_slips` says.
double violation(const StickMobility& a, const StickVector& b, const StickVector& limit) {
  std::array<Slip, most_sticking> slips{};
  StickVector f;
  settle_slips(a, b, limit, slips.data(), f);
  const StickVector acceleration = b - a * f;
  double worst = 0;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    const double left = acceleration(i);
    const Slip slip = slips[static_cast<std::size_t>(i)];
    worst = std::max(worst, std::abs(f(i)) - limit(i));
    worst = std::max(worst, slip == Slip::sticking  ? std::abs(left)
                            : slip == Slip::forward ? std::abs(f(i) - limit(i)) - std::min(0.0, left)
                                                    : std::abs(f(i) + limit(i)) + std::max(0.0, left));
  }
  return worst;
}

TEST(DryFriction, SeveralSurfacesObeyTheLawTogether) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 2000; ++trial) {
    const int count = 1 + trial % 4;
    const StickMobility root = StickMobility::NullaryExpr(count, count, [&] { return normal(random); });
    const StickMobility a = root * root.transpose() + 0.05 * StickMobility::Identity(count, count);
    const StickVector b = StickVector::NullaryExpr(count, [&] { return normal(random); });
    const StickVector limit = StickVector::NullaryExpr(count, [&] { return std::abs(normal(random)); });
    EXPECT_LT(violation(a, b, limit), 1e-10) << trial;
  }
}

TEST(DryFriction, OfTwoWallsOfOneBodyOnlyTheSumIsDetermined) {
  StickMobility a = StickMobility::Constant(2, 2, 1);
  EXPECT_LT(violation(a, StickVector::Constant(2, 1), StickVector::Constant(2, 0.7)), 1e-12);
  EXPECT_FALSE(determined(a));
  a(1, 1) = 1.01;
  EXPECT_TRUE(determined(a));
}

}  // namespace
}  // namespace rubsweep::contact
