#include "rubsweep/analysis/branch/continuation/multiplier_slopes.hpp"

#include <gtest/gtest.h>

#include "analysis/branch/continuation/plain_maps.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// x -> A(p) x has the orbit 0, and there the monodromy matrix A: diag(p, 2 p^2, 0.5).
orbits::OrbitProblem linear() {
  orbits::OrbitProblem problem;
  problem.low = 0;
  problem.high = 1;
  problem.returns = [](double p, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    const Eigen::Vector3d diagonal(p, 2 * p * p, 0.5);
    if (monodromy) *monodromy = diagonal.asDiagonal();
    x = diagonal.cwiseProduct(x).eval();
    return p > 0.9 ? orbits::Evaluation::infeasible : orbits::Evaluation::ok;
  };
  return problem;
}

/// The branch runs along p at rest: the slopes are those of the polynomials in p.
TEST(MultiplierSlopes, OfPolynomials) {
  const orbits::OrbitProblem problem = linear();
  for (const double p : {0.4, 0.8999999}) {  // and beside where there is no machine
    const auto point = orbit_from(problem, Eigen::Vector3d::Zero(), p);
    ASSERT_TRUE(point);
    const double a = p, b = 2 * p * p, c = 0.5, db = 4 * p;
    const MultiplierTests tests = tests_of_multipliers(point->multipliers);
    EXPECT_NEAR(tests.unit, (1 - a) * (1 - b) * (1 - c), 1e-14);
    EXPECT_NEAR(tests.doubling, (1 + a) * (1 + b) * (1 + c), 1e-14);
    EXPECT_NEAR(tests.torus, (a * b - 1) * (a * c - 1) * (b * c - 1), 1e-14);
    const MultiplierTests slopes = multiplier_slopes(problem, *point);
    EXPECT_NEAR(slopes.unit, -(1 - b) * (1 - c) - db * (1 - a) * (1 - c), 3e-4);
    EXPECT_NEAR(slopes.doubling, (1 + b) * (1 + c) + db * (1 + a) * (1 + c), 3e-4);
    const double by_torus = (b + a * db) * (a * c - 1) * (b * c - 1) + (a * b - 1) * c * (b * c - 1) +
                            (a * b - 1) * (a * c - 1) * db * c;
    EXPECT_NEAR(slopes.torus, by_torus, 3e-4);
  }
}

/// Along the logistic map's fixed points 1 - 1 / r the multiplier is 2 - r. The branch is longer than r.
TEST(MultiplierSlopes, AlongACurvedBranchPerUnitOfItsLength) {
  orbits::OrbitProblem problem = test::logistic(1, 1.5, 4);
  problem.parameter_scale = 2.5;
  const auto point = orbit_from(problem, test::number(0.5), 2);
  ASSERT_TRUE(point);
  EXPECT_NEAR(multiplier_slopes(problem, *point).unit, 2.5 * point->tangent(1), 3e-4);
  const BranchPoint turned = turned_about(*point);
  EXPECT_NEAR(multiplier_slopes(problem, turned).unit, -2.5 * point->tangent(1), 3e-4);
}

}  // namespace
}  // namespace rubsweep::branch::continuation
