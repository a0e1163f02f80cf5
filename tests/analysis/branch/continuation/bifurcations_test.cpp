#include "rubsweep/analysis/branch/continuation/bifurcations.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/branch/continuation/plain_maps.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"

namespace rubsweep::branch::continuation {
namespace {

using test::number;
using test::one_number;

/// Parameters of the events of `kind` on the single step between two orbits, both given by parameter and a
/// nearby state. `last` lies ahead of `first`.
std::vector<double> found_in_one_step(const orbits::OrbitProblem& problem, EventKind kind,
                                      const BranchPoint& first, const BranchPoint& last) {
  const auto events = events_between(problem, first, last, true);
  if (!events) {
    ADD_FAILURE() << "not one piece";
    return {};
  }
  std::vector<double> parameters;
  for (const BranchEvent& event : *events) {
    EXPECT_EQ(event.kind, kind) << to_string(event.kind);
    EXPECT_LE(event.parameter_error, 1e-11);
    parameters.push_back(event.point.parameter);
  }
  return parameters;
}

std::vector<double> found_in_one_step(const orbits::OrbitProblem& problem, EventKind kind, double p, double q,
                                      const Eigen::VectorXd& state) {
  const auto first = orbit_from(problem, state, p);
  auto last = orbit_from(problem, state, q);
  if (!first || !last) {
    ADD_FAILURE() << "no orbits";
    return {};
  }
  last->arclength = q - p;
  return found_in_one_step(problem, kind, *first, *last);
}

/// A map with the fixed point 0 and the multiplier `m`, a function of p.
template <class Multiplier>
orbits::OrbitProblem with_multiplier(const Multiplier& m) {
  return one_number([m](double x, double p) { return m(p) * x - x * x * x; },
                    [m](double x, double p) { return m(p) - 3 * x * x; }, -1, 2);
}

/// The multiplier passes -1 at 0.4 and passes it again at 0.6, so it has the same sign at 0 and 1.
TEST(Bifurcations, TwoPeriodDoublingsInOneStep) {
  const auto problem = with_multiplier([](double p) { return -1 + 3 * (p - 0.4) * (p - 0.6); });
  const auto found = found_in_one_step(problem, EventKind::period_doubling, 0, 1, number(0));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 0.4, 1e-11);
  EXPECT_NEAR(found[1], 0.6, 1e-11);
}

/// The multiplier is not a cubic, its roots lie at one end of the step, and it passes -1 only slightly.
TEST(Bifurcations, TwoPeriodDoublingsNearTheEndOfAStep) {
  const auto problem =
      with_multiplier([](double p) { return -1 + 0.3 * (std::cosh(3 * (p - 0.8)) - std::cosh(0.06)); });
  const auto found = found_in_one_step(problem, EventKind::period_doubling, 0, 1, number(0));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 0.78, 1e-11);
  EXPECT_NEAR(found[1], 0.82, 1e-11);
}

TEST(Bifurcations, ThreePeriodDoublingsInOneStep) {
  const auto problem = with_multiplier([](double p) { return -1 + 9 * (p - 0.2) * (p - 0.5) * (p - 0.9); });
  const auto found = found_in_one_step(problem, EventKind::period_doubling, 0, 1, number(0));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(found[0], 0.2, 1e-11);
  EXPECT_NEAR(found[1], 0.5, 1e-11);
  EXPECT_NEAR(found[2], 0.9, 1e-11);
}

/// A multiplier that turns back before reaching -1 gives no event.
TEST(Bifurcations, NoneWhereTheMultiplierTurnsBack) {
  const auto problem = with_multiplier([](double p) { return -1 + (p - 0.5) * (p - 0.5) + 0.001; });
  EXPECT_TRUE(found_in_one_step(problem, EventKind::period_doubling, 0, 1, number(0)).empty());
}

/// x -> (1 + (p - 0.4) (p - 0.6)) x - x^3: the symmetric orbit 0 is stable only between 0.4 and 0.6.
TEST(Bifurcations, TwoBranchPointsInOneStep) {
  const auto problem = with_multiplier([](double p) { return 1 + (p - 0.4) * (p - 0.6); });
  const auto found = found_in_one_step(problem, EventKind::branch_point, 0, 1, number(0));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 0.4, 1e-9);
  EXPECT_NEAR(found[1], 0.6, 1e-9);
}

/// A rotation whose modulus passes 1 twice in one step.
TEST(Bifurcations, TwoToriInOneStep) {
  orbits::OrbitProblem problem;
  problem.low = 0;
  problem.high = 1;
  problem.returns = [](double p, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    const double modulus = 1 + 2 * (p - 0.4) * (p - 0.6);
    const Eigen::Matrix2d matrix = modulus * Eigen::Rotation2Dd(1).toRotationMatrix();
    if (monodromy) *monodromy = matrix;
    x = (matrix * x).eval();
    return orbits::Evaluation::ok;
  };
  const auto found = found_in_one_step(problem, EventKind::neimark_sacker, 0, 1, Eigen::Vector2d::Zero());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0], 0.4, 1e-11);
  EXPECT_NEAR(found[1], 0.6, 1e-11);
}

/// p = 0.1 (x^3 - 0.03 x) has folds at x = -0.1 and x = 0.1, and the direction of the branch hardly changes:
/// continuation with steps of up to 1 passes both folds at once.
TEST(Bifurcations, TwoFoldsInOneStep) {
  const auto parameter_of = [](double x) { return 0.1 * (x * x * x - 0.03 * x); };
  const auto problem = one_number([&](double x, double p) { return x + p - parameter_of(x); },
                                  [](double x, double) { return 1 - 0.1 * (3 * x * x - 0.03); }, -1, 1);
  const auto start = orbit_from(problem, number(-0.5), parameter_of(-0.5));
  ASSERT_TRUE(start);
  FollowOptions long_steps;
  long_steps.first_step = long_steps.longest_step = 1;
  const HalfBranch half = follow(problem, *start, long_steps);
  ASSERT_EQ(half.events.size(), 2u);
  EXPECT_GT(half.points.at(1).state(0), 0.1) << "both folds are in the first step";
  EXPECT_EQ(half.events[0].kind, EventKind::fold);
  EXPECT_NEAR(half.events[0].point.state(0), -0.1, 1e-10);
  EXPECT_NEAR(half.events[0].point.parameter, parameter_of(-0.1), 1e-12);
  EXPECT_NEAR(half.events[1].point.state(0), 0.1, 1e-10);
}

}  // namespace
}  // namespace rubsweep::branch::continuation
