#include "rubsweep/branch/orbit_newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "branch/plain_maps.hpp"

namespace rubsweep::branch {
namespace {

using test::number;

/// x -> x + p - x^2 with the orbits p = x^2, on a plane that is neither that of p nor that of x.
OrbitProblem parabola() {
  return test::one_number([](double x, double p) { return x + p - x * x; },
                          [](double x, double) { return 1 - 2 * x; }, -1, 1);
}

TEST(OrbitNewton, StaysOnItsPlane) {
  const OrbitProblem problem = parabola();
  const Position guess = Eigen::Vector2d(0.4, 0.3), direction = Eigen::Vector2d(0.6, 0.8);
  const Correction found = correct(problem, guess, direction);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.point.parameter, found.point.state(0) * found.point.state(0), 1e-12);
  EXPECT_NEAR(direction.dot(position_of(problem, found.point) - guess), 0, 1e-12);
}

TEST(OrbitNewton, TangentAndTestOfBranchPoints) {
  const OrbitProblem problem = parabola();
  Correction found = correct_at(problem, number(0.45), 0.25);
  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.point.state(0), 0.5, 1e-12);
  ASSERT_TRUE(complete(problem, Eigen::Vector2d(0, -1), found.point));
  // dp = 2 x dx, towards falling p
  EXPECT_NEAR(found.point.tangent(0), -std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(found.point.tangent(1), -std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(found.point.multipliers(0).real(), 0, 1e-12);
}

TEST(OrbitNewton, SaysWhatTheMapCouldNotMake) {
  OrbitProblem problem = parabola();
  problem.returns = [](double, Eigen::VectorXd&, Eigen::MatrixXd*) { return Evaluation::infeasible; };
  EXPECT_EQ(correct_at(problem, number(0.5), 0.25).evaluation, Evaluation::infeasible);
  EXPECT_FALSE(correct_at(problem, number(0.5), 0.25).converged);
}

}  // namespace
}  // namespace rubsweep::branch
