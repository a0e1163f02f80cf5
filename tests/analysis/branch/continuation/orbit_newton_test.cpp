#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/branch/continuation/plain_maps.hpp"

namespace rubsweep::branch::continuation {
namespace {

using test::number;

/// x -> x + p - x^2 has the orbits p = x^2. The plane of the Newton steps is parallel to neither axis.
orbits::OrbitProblem parabola() {
  return test::one_number([](double x, double p) { return x + p - x * x; },
                          [](double x, double) { return 1 - 2 * x; }, -1, 1);
}

TEST(OrbitNewton, StaysOnItsPlane) {
  const orbits::OrbitProblem problem = parabola();
  const Position guess = Eigen::Vector2d(0.4, 0.3), direction = Eigen::Vector2d(0.6, 0.8);
  const Correction found = correct(problem, guess, direction);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.point.parameter, found.point.state(0) * found.point.state(0), 1e-12);
  EXPECT_NEAR(direction.dot(position_of(problem, found.point) - guess), 0, 1e-12);
}

TEST(OrbitNewton, TangentAndTestOfBranchPoints) {
  const orbits::OrbitProblem problem = parabola();
  Correction found = correct_at(problem, number(0.45), 0.25);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.point.state(0), 0.5, 1e-12);
  ASSERT_TRUE(complete(problem, Eigen::Vector2d(0, -1), found.point));
  // dp = 2 x dx, in the direction of decreasing p
  EXPECT_NEAR(found.point.tangent(0), -std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(found.point.tangent(1), -std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(found.point.multipliers(0).real(), 0, 1e-12);
}

TEST(OrbitNewton, SaysWhatTheMapCouldNotMake) {
  orbits::OrbitProblem problem = parabola();
  problem.returns = [](double, Eigen::VectorXd&, Eigen::MatrixXd*) { return orbits::Evaluation::infeasible; };
  EXPECT_EQ(correct_at(problem, number(0.5), 0.25).evaluation, orbits::Evaluation::infeasible);
  EXPECT_FALSE(correct_at(problem, number(0.5), 0.25).converged);
}

/// x -> x / 2 + p + 5 sqrt(p - 0.3), with the root only for p > 0.3, as after a graze; below that x = 2 p. A
/// difference across 0.3 does not give the branch's slope.
TEST(OrbitNewton, DifferencesDoNotLeadOverAGraze) {
  const auto problem =
      test::one_number([](double x, double p) { return 0.5 * x + p + 5 * std::sqrt(std::max(p - 0.3, 0.0)); },
                       [](double, double) { return 0.5; }, 0, 1);
  for (const double distance : {1e-3, 3e-7, 2e-8, 1e-11}) {
    const Correction found = correct_at(problem, test::number(0.6), 0.3 - distance);
    ASSERT_TRUE(found.converged);
    BranchPoint point = found.point;
    ASSERT_TRUE(complete(problem, Eigen::Vector2d(0, 1), point));
    EXPECT_NEAR(point.tangent(0) / point.tangent(1), 2, 1e-4) << distance;
    EXPECT_LT(point.slope_difference, 1e-3) << distance;
    EXPECT_EQ(point.difference_step == usual_difference_step, distance == 1e-3);
  }
}

}  // namespace
}  // namespace rubsweep::branch::continuation
