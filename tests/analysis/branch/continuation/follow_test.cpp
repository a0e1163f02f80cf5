#include "rubsweep/analysis/branch/continuation/follow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "analysis/branch/continuation/plain_maps.hpp"

namespace rubsweep::branch::continuation {
namespace {

using test::number;
using test::one_number;

/// The two-cycle of the logistic map begins at r = 3, has the multiplier 4 + 2 r - r^2 and doubles its period
/// at 1 + sqrt(6).
TEST(FollowDoublingDoubledStart, TheTwoCycleOfTheLogisticMap) {
  const orbits::OrbitProblem single = test::logistic(1, 2, 3.2), doubled = test::logistic(2, 2, 3.6);
  const auto start = orbit_from(single, test::number(0.6), 2.5);
  ASSERT_TRUE(start);
  const HalfBranch branch = follow(single, *start, {});
  ASSERT_EQ(branch.events.size(), 1u);
  const auto beside = doubled_start(doubled, branch.events[0].point);
  ASSERT_TRUE(beside);
  EXPECT_GT(beside->parameter, 3);
  const HalfBranch cycle = follow(doubled, *beside, {});
  ASSERT_EQ(cycle.events.size(), 1u);
  EXPECT_EQ(cycle.events[0].kind, EventKind::period_doubling);
  EXPECT_NEAR(cycle.events[0].point.parameter, 1 + std::sqrt(6), 1e-10);
  for (const BranchPoint& point : cycle.points) {
    const double r = point.parameter;
    EXPECT_NEAR(point.multipliers(0).real(), 4 + 2 * r - r * r, 1e-8);
  }
}

Branch followed(const orbits::OrbitProblem& problem, const Eigen::VectorXd& near, double parameter) {
  const auto start = orbit_from(problem, near, parameter);
  EXPECT_TRUE(start);
  return start ? follow_both_ways(problem, *start, {}) : Branch{};
}

std::vector<EventKind> kinds(const Branch& branch) {
  std::vector<EventKind> kinds;
  for (const BranchEvent& event : branch.events) kinds.push_back(event.kind);
  return kinds;
}

/// Fixed points of the logistic map: x = 1 - 1 / r, with the multiplier 2 - r.
TEST(Follow, FixedPointsUpToThePeriodDoublingAndBeyond) {
  const Branch branch = followed(test::logistic(1, 1.5, 4), number(0.5), 2);
  ASSERT_EQ(kinds(branch), std::vector{EventKind::period_doubling});
  EXPECT_NEAR(branch.events[0].point.parameter, 3, 1e-11);
  EXPECT_LE(branch.events[0].parameter_error, 1e-11);
  EXPECT_EQ(branch.falling, Ending::left_range);
  EXPECT_EQ(branch.rising, Ending::left_range);
  EXPECT_EQ(branch.points.front().parameter, 1.5);
  EXPECT_EQ(branch.points.back().parameter, 4);
  for (const BranchPoint& point : branch.points) {
    EXPECT_NEAR(point.state(0), 1 - 1 / point.parameter, 1e-11);
    EXPECT_NEAR(point.multipliers(0).real(), 2 - point.parameter, 1e-9);
    EXPECT_EQ(point.stable(), point.parameter < 3);
    EXPECT_LT(point.slope_difference, 1e-6);
  }
}

/// x -> x + p - x^2 has x = +-sqrt(p), which meet in a fold at p = 0.
TEST(Follow, ThroughAFold) {
  const auto problem = one_number([](double x, double p) { return x + p - x * x; },
                                  [](double x, double) { return 1 - 2 * x; }, -1, 0.64);
  const Branch branch = followed(problem, number(0.5), 0.25);
  ASSERT_EQ(kinds(branch), std::vector{EventKind::fold});
  EXPECT_NEAR(branch.events[0].point.parameter, 0, 1e-12);
  EXPECT_NEAR(branch.points.front().state(0), -0.8, 1e-11);
  EXPECT_NEAR(branch.points.back().state(0), 0.8, 1e-11);
  for (const BranchPoint& point : branch.points) EXPECT_EQ(point.stable(), point.state(0) > 0);
}

/// x -> (1 + p) x - x^3: the symmetric fixed point 0 loses stability at p = 0, while the branch continues.
TEST(Follow, ThroughABreakOfSymmetry) {
  const auto problem = one_number([](double x, double p) { return (1 + p) * x - x * x * x; },
                                  [](double x, double p) { return 1 + p - 3 * x * x; }, -0.5, 0.5);
  const Branch branch = followed(problem, number(0), -0.3);
  ASSERT_EQ(kinds(branch), std::vector{EventKind::branch_point});
  EXPECT_NEAR(branch.events[0].point.parameter, 0, 1e-11);
  EXPECT_EQ(branch.rising, Ending::left_range);
}

/// The delayed logistic map (x, y) -> (a x (1 - y), x) has a torus bifurcation at a = 2 with the multipliers
/// e^{+-i pi / 3}.
TEST(Follow, ThroughATorus) {
  orbits::OrbitProblem problem;
  problem.low = 1.5;
  problem.high = 2.5;
  problem.returns = [](double a, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    if (monodromy) *monodromy = (Eigen::MatrixXd(2, 2) << a * (1 - x(1)), -a * x(0), 1, 0).finished();
    x = Eigen::Vector2d(a * x(0) * (1 - x(1)), x(0));
    return orbits::Evaluation::ok;
  };
  const Branch branch = followed(problem, Eigen::Vector2d(0.4, 0.4), 1.7);
  ASSERT_EQ(kinds(branch), std::vector{EventKind::neimark_sacker});
  EXPECT_NEAR(branch.events[0].point.parameter, 2, 1e-11);
  EXPECT_NEAR(branch.events[0].point.multipliers(0).real(), 0.5, 1e-10);
}

/// Two coordinates double their periods at the same parameter: no determinant changes sign, but the number of
/// unstable multipliers does.
TEST(Follow, TwoEventsAtOneParameter) {
  orbits::OrbitProblem problem;
  problem.low = 2.5;
  problem.high = 3.5;
  problem.returns = [](double r, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    if (monodromy) *monodromy = Eigen::Vector2d(r * (1 - 2 * x(0)), r * (1 - 2 * x(1))).asDiagonal();
    x = (r * x.array() * (1 - x.array())).matrix().eval();
    return orbits::Evaluation::ok;
  };
  const Branch branch = followed(problem, Eigen::Vector2d(0.63, 0.63), 2.7);
  ASSERT_EQ(kinds(branch), std::vector{EventKind::stability});
  EXPECT_NEAR(branch.events[0].point.parameter, 3, 1e-9);
  EXPECT_EQ(branch.points.back().unstable, 2);
}

/// x -> x + (1 - x^2 - p^2) / 4: the fixed points are a circle.
TEST(Follow, ABranchThatCloses) {
  const auto problem = one_number([](double x, double p) { return x + (1 - x * x - p * p) / 4; },
                                  [](double x, double) { return 1 - x / 2; }, -2, 2);
  const Branch branch = followed(problem, number(0.9), 0.3);
  EXPECT_EQ(branch.rising, Ending::closed);
  EXPECT_EQ(branch.falling, Ending::closed);
  ASSERT_EQ(kinds(branch), (std::vector{EventKind::fold, EventKind::fold}));
  EXPECT_NEAR(branch.events[0].point.parameter, 1, 1e-11);
  EXPECT_NEAR(branch.events[1].point.parameter, -1, 1e-11);
  EXPECT_NEAR(branch.points.back().parameter, branch.points.front().parameter, 1e-8);
  EXPECT_NEAR(branch.points.back().state(0), branch.points.front().state(0), 1e-8);
}

TEST(Follow, EndsWhereThereIsNoMachine) {
  orbits::OrbitProblem problem = test::logistic(1, 1.5, 4);
  problem.returns = [map = problem.returns](double r, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    return r > 2.5 ? orbits::Evaluation::infeasible : map(r, x, monodromy);
  };
  const Branch branch = followed(problem, number(0.5), 2);
  EXPECT_EQ(branch.rising, Ending::infeasible);
  EXPECT_NEAR(branch.points.back().parameter, 2.5, 1e-6);
}

TEST(Follow, EndsWhereTheSolverFails) {
  orbits::OrbitProblem problem = test::logistic(1, 1.5, 4);
  problem.returns = [map = problem.returns](double r, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    return r < 1.8 ? orbits::Evaluation::failed : map(r, x, monodromy);
  };
  EXPECT_EQ(followed(problem, number(0.5), 2).falling, Ending::failed);
}

/// The fixed point jumps from 0.5 to 0.8 at p = 0.3: there is no orbit near the last one.
TEST(Follow, EndsWhereTheOrbitIsLost) {
  const auto problem = one_number([](double x, double p) { return x + 0.5 * ((p < 0.3 ? 0.5 : 0.8) - x); },
                                  [](double, double) { return 0.5; }, 0, 1);
  const Branch branch = followed(problem, number(0.5), 0.1);
  EXPECT_EQ(branch.rising, Ending::step_too_small);
  EXPECT_NEAR(branch.points.back().parameter, 0.3, 1e-4);
}

TEST(Follow, EndsAtTheLimitOfPoints) {
  const orbits::OrbitProblem problem = test::logistic(1, 1.5, 4);
  const auto start = orbit_from(problem, number(0.5), 2);
  ASSERT_TRUE(start);
  FollowOptions few;
  few.most_points = 5;
  const HalfBranch half = follow(problem, *start, few);
  EXPECT_EQ(half.ending, Ending::point_limit);
  EXPECT_EQ(half.points.size(), 5u);
}

TEST(Follow, StopsAtTheFirstChangeOfStability) {
  const orbits::OrbitProblem problem = test::logistic(1, 1.5, 4);
  const auto start = orbit_from(problem, number(0.5), 2);
  ASSERT_TRUE(start);
  FollowOptions stable;
  stable.stop_at_first_change = true;
  const HalfBranch half = follow(problem, *start, stable);
  EXPECT_EQ(half.ending, Ending::first_change);
  EXPECT_NEAR(half.points.back().parameter, 3, 1e-11);
}

TEST(Follow, NoOrbitNoStart) {
  const auto problem =
      one_number([](double x, double) { return x + 1; }, [](double, double) { return 1.0; }, 0, 1);
  EXPECT_FALSE(orbit_from(problem, number(0.5), 0.5));
}

}  // namespace
}  // namespace rubsweep::branch::continuation
