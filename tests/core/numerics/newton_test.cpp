#include "rubsweep/core/numerics/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::numerics {
namespace {

/// The equation x^2 = 2 or, with `constant` < 0, an equation without a solution.
struct SquareRoot {
  std::optional<double> error(int i, double) {
    iterations = i + 1;
    if (i == fails_at) return std::nullopt;
    return std::abs(x * x - constant);
  }
  static bool converged(int, double error, double) { return error < 1e-14; }
  bool step(int) {
    x -= (x * x - constant) / (2 * x);
    return true;
  }

  double x = 1, constant = 2;
  int iterations = 0, fails_at = -1;
};

TEST(Newton, ConvergesToTheRoot) {
  SquareRoot problem{.x = 1.4};
  EXPECT_TRUE(newton(problem, {.iterations = 8}));
  EXPECT_NEAR(problem.x, std::sqrt(2.0), 1e-14);
  EXPECT_LT(problem.iterations, 6);
}

TEST(Newton, EndsWhereTheErrorGrowsUnlessItMayAtFirst) {
  SquareRoot far{.x = 0.1};  // 0.1 -> 10.05 -> 5.1 -> ...
  EXPECT_FALSE(newton(far, {.iterations = 20}));
  EXPECT_EQ(far.iterations, 2);
  SquareRoot free{.x = 0.1};
  EXPECT_TRUE(newton(free, {.iterations = 20, .free_iterations = 2}));
  SquareRoot strict{.x = 10};  // each error is slightly more than a quarter of the previous one
  EXPECT_FALSE(newton(strict, {.iterations = 20, .free_iterations = 0, .growth = 0.2}));
}

TEST(Newton, EndsAtTheLimitAndWhereTheMapFails) {
  SquareRoot nowhere{.x = 3, .constant = -1};
  EXPECT_FALSE(newton(nowhere, {.iterations = 5, .free_iterations = 5}));
  EXPECT_EQ(nowhere.iterations, 5);
  SquareRoot fails{.x = 3, .fails_at = 1};
  EXPECT_FALSE(newton(fails, {.iterations = 5}));
  EXPECT_EQ(fails.iterations, 2);
}

}  // namespace
}  // namespace rubsweep::numerics
