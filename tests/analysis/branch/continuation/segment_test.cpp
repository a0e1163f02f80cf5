#include "rubsweep/analysis/branch/continuation/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/branch/continuation/plain_maps.hpp"
#include "rubsweep/analysis/branch/continuation/bifurcations.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// Test data: fixed points x = 1 - 1 / r of the logistic map.
class SegmentLogistic : public ::testing::Test {
 protected:
  SegmentLogistic()
      : from_(orbit_from(problem_, test::number(0.6), 2.5).value()),
        to_(orbit_from(problem_, test::number(0.63), 2.7).value()) {}

  orbits::OrbitProblem problem_ = test::logistic(1, 1.5, 4);
  BranchPoint from_, to_;
};

TEST_F(SegmentLogistic, OrbitsInBetweenAtTheirDistance) {
  const Segment segment(problem_, from_, to_);
  EXPECT_GT(segment.length(), 0.2);
  for (const double share : {0.25, 0.5, 0.9}) {
    const double s = share * segment.length();
    const auto point = segment.at(s);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->state(0), 1 - 1 / point->parameter, 1e-12);
    EXPECT_NEAR(from_.tangent.dot(position_of(problem_, *point) - position_of(problem_, from_)), s, 1e-12);
  }
  EXPECT_EQ(segment.at(0)->parameter, 2.5);
  EXPECT_EQ(segment.at(segment.length())->parameter, 2.7);
}

TEST_F(SegmentLogistic, NeighboursBelongTogetherAndOthersDoNot) {
  const Segment segment(problem_, from_, to_);
  EXPECT_TRUE(continuous(problem_, *segment.at(0.1), *segment.at(0.1 + 1e-9)));
  EXPECT_FALSE(continuous(problem_, from_, to_));
}

TEST_F(SegmentLogistic, PassesThroughItsOwnPointsAlone) {
  const Segment segment(problem_, from_, to_);
  const auto on_it = segment.through(position_of(problem_, test::number(1 - 1 / 2.6), 2.6));
  ASSERT_TRUE(on_it);
  EXPECT_NEAR(on_it->parameter, 2.6, 1e-12);
  EXPECT_FALSE(segment.through(position_of(problem_, test::number(0.62), 2.6))) << "beside it";
  EXPECT_FALSE(segment.through(position_of(problem_, test::number(1 - 1 / 2.8), 2.8))) << "beyond it";
}

/// No event lies below r = 3; a step across 3 contains the period doubling.
TEST_F(SegmentLogistic, EventsBetweenItsEnds) {
  const auto none = events_between(problem_, from_, to_, true);
  ASSERT_TRUE(none);
  EXPECT_TRUE(none->empty());
  const BranchPoint beyond = orbit_from(problem_, test::number(0.68), 3.1).value();
  const auto one = events_between(problem_, to_, beyond, true);
  ASSERT_TRUE(one);
  ASSERT_EQ(one->size(), 1u);
  EXPECT_EQ(one->front().kind, EventKind::period_doubling);
  EXPECT_NEAR(one->front().point.parameter, 3, 1e-11);
  EXPECT_FALSE(events_between(problem_, beyond, to_, true));  // the other end does not lie ahead
}

/// Points on the line from 0 to 2; each number is its own distance.
struct Line {
  static double length() { return 2; }
  static double required_at(double s) { return s; }
};

TEST(SegmentEventRoots, TheRootOfATestFunctionIsEnclosed) {
  const auto root = root_on(Line{}, [](double x) { return x * x * x - 2; });
  ASSERT_TRUE(root);
  EXPECT_LE(root->high - root->low, event_width);
  EXPECT_LE(root->low * root->low * root->low, 2);
  EXPECT_GE(root->high * root->high * root->high, 2);
}

TEST(SegmentEventRoots, NoRootWithoutAChangeOfSign) {
  EXPECT_FALSE(root_on(Line{}, [](double x) { return (x - 1) * (x - 1) - 0.1; }));
}

TEST(SegmentEventRoots, ChangesOneAfterTheOther) {
  const auto first = change_on(Line{}, 0, 0.0, [](double x) { return x > 0.3; });
  EXPECT_LE(first.at.high - first.at.low, event_width);
  EXPECT_LE(first.before, 0.3);
  EXPECT_GT(first.behind, 0.3);
  EXPECT_NEAR(first.behind, 0.3, event_width);
  const auto second = change_on(Line{}, first.at.high, first.behind, [](double x) { return x > 1.7; });
  EXPECT_NEAR(second.behind, 1.7, event_width);
}

}  // namespace

}  // namespace rubsweep::branch::continuation
