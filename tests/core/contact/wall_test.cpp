#include "rubsweep/core/contact/wall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::contact {
namespace {

const Wall flat = FlatWall{{std::sqrt(0.5), std::sqrt(0.5)}};
const Wall hole = AnnularWall{{0.3, -0.4}};

TEST(Wall, IsThatOfTheStop) {
  const Wall up = wall_of(model::OneSideGeometry{.angle_deg = 90});
  EXPECT_EQ(first_direction(up), Eigen::Vector2d(0, 1));  // exact: rounding must not couple x into y
  EXPECT_TRUE(linear(up));
  const Wall annular = wall_of(model::AnnularGeometry{.offset_m = {1e-3, 2e-3}});
  EXPECT_EQ(offset(annular), Eigen::Vector2d(1e-3, 2e-3));
  EXPECT_FALSE(linear(annular));
}

TEST(Wall, DirectionsAreExactAtTheQuarterTurns) {
  EXPECT_EQ(direction(-270), Eigen::Vector2d(0, 1));
  EXPECT_EQ(direction(180), Eigen::Vector2d(-1, 0));
  EXPECT_NEAR((direction(30) - Eigen::Vector2d(std::sqrt(0.75), 0.5)).norm(), 0, 1e-15);
}

TEST(Wall, OnlyACentredHoleLooksTheSameFromEverywhere) {
  EXPECT_TRUE(centred(AnnularWall{}));
  EXPECT_FALSE(centred(hole));
  EXPECT_FALSE(centred(flat));
}

TEST(Wall, IsTheSameByShapeAndNumbers) {
  EXPECT_TRUE(same(flat, flat));
  EXPECT_TRUE(same(hole, AnnularWall{{0.3, -0.4}}));
  EXPECT_FALSE(same(hole, AnnularWall{}));
  EXPECT_FALSE(same(FlatWall{}, AnnularWall{}));
}

/// The kinematics of a contact equal the derivatives of the penetration along a motion d(t).
TEST(Wall, KinematicsAreThePenetrationsDerivatives) {
  const auto d = [](double t) { return Eigen::Vector2d(0.8 * std::cos(t) + 0.1 * t, 0.9 * std::sin(2 * t)); };
  const auto v = [](double t) { return Eigen::Vector2d(-0.8 * std::sin(t) + 0.1, 1.8 * std::cos(2 * t)); };
  const auto a = [](double t) { return Eigen::Vector2d(-0.8 * std::cos(t), -3.6 * std::sin(2 * t)); };
  const double clearance = 0.7, h = 1e-4;
  const auto at = [&](const Wall& wall, double t, bool open) {
    const RelativeMotion m{d(t).x(), d(t).y(), v(t).x(), v(t).y()};
    return open ? open_kinematics(wall, m, a(t).x(), a(t).y(), clearance)
                : kinematics(wall, m, a(t).x(), a(t).y(), clearance);
  };
  for (const Wall& wall : {Wall(FlatWall{}), Wall(AnnularWall{})}) {
    for (const bool open : {false, true}) {
      for (double t = 0.1; t < 6; t += 0.1) {
        const Kinematics now = at(wall, t, open), before = at(wall, t - h, open),
                         after = at(wall, t + h, open);
        EXPECT_NEAR(now.closing_speed, (after.penetration - before.penetration) / (2 * h), 1e-6);
        EXPECT_NEAR(now.closing_acceleration, (after.closing_speed - before.closing_speed) / (2 * h), 1e-4);
        const double penetration = at(wall, t, false).penetration;
        EXPECT_EQ(now.penetration > 0, penetration > 0) << "at " << t;  // open: only the sign must agree
      }
    }
  }
}

TEST(Wall, NormalPointsAtIt) {
  EXPECT_EQ(normal_at(flat, {5, -7}), first_direction(flat));
  EXPECT_NEAR((normal_at(hole, {3, 4}) - Eigen::Vector2d(0.6, 0.8)).norm(), 0, 1e-15);
  EXPECT_EQ(normal_at(hole, {0, 0}), Eigen::Vector2d(0, 1));
}

TEST(Wall, ShareOfTheWayEndsOnIt) {
  const Eigen::Vector2d way(0.9, 0.2);
  const double to_flat = share_of_way_to(flat, 0.5, way), to_hole = share_of_way_to(hole, 0.6, way);
  EXPECT_NEAR(first_direction(flat).dot(to_flat * way), 0.5, 1e-15);
  EXPECT_NEAR((to_hole * way + offset(hole)).norm(), 0.6, 1e-15);
  EXPECT_GT(to_hole, 0);
  // The outline describes the same wall in another form.
  EXPECT_FALSE(outline(flat, 0.5).circle);
  EXPECT_NEAR(outline(flat, 0.5).normal.dot(to_flat * way), 0.5, 1e-15);
  EXPECT_TRUE(outline(hole, 0.6).circle);
  EXPECT_NEAR((to_hole * way - outline(hole, 0.6).centre).norm(), 0.6, 1e-15);
  EXPECT_EQ(outline(flat, 0.5).reach, 0.5);
  EXPECT_EQ(outline(hole, 0.6).reach, 0.6);
  EXPECT_NEAR(penetration_at(flat, to_flat * way, 0.5), 0, 1e-15);
  EXPECT_NEAR(penetration_at(hole, to_hole * way + offset(hole), 0.6), 0, 1e-15);
  EXPECT_NEAR(penetration_at(hole, {0.6, 0.8}, 0.6), 0.4, 1e-15);
  EXPECT_TRUE(std::isinf(share_of_way_to(flat, 0.5, -way)));
  EXPECT_TRUE(std::isinf(share_of_way_to(hole, 0.6, {0, 0})));
}

}  // namespace
}  // namespace rubsweep::contact
