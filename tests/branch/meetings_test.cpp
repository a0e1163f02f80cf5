#include "rubsweep/branch/meetings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "branch/cusp_plane.hpp"

namespace rubsweep::branch {
namespace {

TEST(Meetings, ACuspOnAStepOverIt) {
  const test::FoldsOfACusp folds;
  const auto before = folds.point(-0.03), behind = folds.point(0.05), farther = folds.point(0.1);
  ASSERT_TRUE(before && behind && farther);
  const auto meetings = meetings_between(folds.system, *before, *behind);
  ASSERT_TRUE(meetings);
  ASSERT_EQ(meetings->size(), 1u);
  EXPECT_EQ(meetings->front().kind, MeetingKind::cusp);
  EXPECT_NEAR(meetings->front().point.state(0), 0, 1e-9);
  EXPECT_LE(meetings->front().error, 1e-12);
  EXPECT_TRUE(meetings_between(folds.system, *behind, *farther)->empty());
  EXPECT_FALSE(meetings_between(folds.system, *behind, *before)) << "the tangent leads the other way";
}

/// What happens to the contacts at q = 0.12 is found to the same width, and called after the curve.
TEST(Meetings, AGrazeOnACurveOfFolds) {
  test::FoldsOfACusp folds;
  folds.orbits.facts = [](const Place& at, const Eigen::VectorXd&) {
    OrbitFacts facts;
    if (at.second > 0.12)
      facts.switches = {{1, 0, contact::Mode::open, contact::Mode::sprung},
                        {1.1, 0, contact::Mode::sprung, contact::Mode::open}};
    return std::optional(facts);
  };
  const auto from = folds.point(0.15), to = folds.point(0.25);
  ASSERT_TRUE(from && to);
  const auto meetings = meetings_between(folds.system, *from, *to);
  ASSERT_TRUE(meetings);
  ASSERT_EQ(meetings->size(), 1u);
  EXPECT_EQ(meetings->front().kind, MeetingKind::graze_fold);
  EXPECT_NEAR(meetings->front().point.place.second, 0.12, 1e-11);
  EXPECT_NEAR(meetings->front().point.state(0), 0.2, 1e-11);
}

/// z -> (1 + p) e^{i pi (q + 1) / 2} z has tori at p = 0, of the angle 90 degrees at q = 0 and 120 at 1/3.
TEST(Meetings, TwoResonancesInOneStepInTheirOrder) {
  const auto turn = [](double p, double q) {
    const double angle = std::numbers::pi * (q + 1) / 2;
    return Eigen::Matrix2d((1 + p) * Eigen::Rotation2Dd(angle).toRotationMatrix());
  };
  const PlaneOrbits orbits = test::plain_plane(
      [turn](double p, double q, const Eigen::VectorXd& x) { return Eigen::VectorXd(turn(p, q) * x); },
      [turn](double p, double q, const Eigen::VectorXd&) { return Eigen::MatrixXd(turn(p, q)); });
  const ExtendedSystem system{&orbits, EventKind::neimark_sacker, 2};
  Position direction = Position::Zero(4);
  direction(3) = 1;
  const auto point_at = [&](double q) {
    const CurveCorrection found =
        correct(system, position_of(system, {0, q, 0}, Eigen::Vector2d::Zero()), direction);
    return completed(system, found, direction, q);
  };
  const auto from = point_at(-0.2), to = point_at(0.5);
  ASSERT_TRUE(from && to);
  const auto meetings = meetings_between(system, *from, *to);
  ASSERT_TRUE(meetings);
  ASSERT_EQ(meetings->size(), 2u);
  EXPECT_EQ((*meetings)[0].kind, MeetingKind::resonance_1_4);
  EXPECT_NEAR((*meetings)[0].point.place.second, 0, 1e-11);
  EXPECT_EQ((*meetings)[1].kind, MeetingKind::resonance_1_3);
  EXPECT_NEAR((*meetings)[1].point.place.second, 1.0 / 3, 1e-11);
}

}  // namespace
}  // namespace rubsweep::branch
