#include "rubsweep/measurement/fit/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

/// Residuals a e^{-b t} - 3 e^{-2 t} at t = 0, 0.1, ...
Eigen::VectorXd decay(const Eigen::VectorXd& at) {
  Eigen::VectorXd left(40);
  for (Eigen::Index k = 0; k < left.size(); ++k) {
    const double t = 0.1 * static_cast<double>(k);
    left(k) = at(0) * std::exp(-at(1) * t) - 3 * std::exp(-2 * t);
  }
  return left;
}

const std::vector<Parameter> two{{"a", 1, 0, 10, 1}, {"b", 0.5, 0, 10, 1}};

TEST(LeastSquares, FindsTheValuesThatMadeTheData) {
  const LeastSquaresFit fit = least_squares({two, decay});
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.value(0), 3, 1e-7);
  EXPECT_NEAR(fit.value(1), 2, 1e-7);
  EXPECT_FALSE(fit.at_bound[0] || fit.at_bound[1]);
  // d / da = e^{-b t}, d / db = -a t e^{-b t} at t = 0.5.
  EXPECT_NEAR(fit.jacobian(5, 0), std::exp(-1.0), 1e-7);
  EXPECT_NEAR(fit.jacobian(5, 1), -1.5 * std::exp(-1.0), 1e-6);
}

TEST(LeastSquares, StaysBetweenBoundsAndSaysSo) {
  auto bounded = two;
  bounded[1].high = 1.5;
  const LeastSquaresFit fit = least_squares({bounded, decay});
  EXPECT_NEAR(fit.value(1), 1.5, 1e-6);
  EXPECT_TRUE(fit.at_bound[1]);
}

TEST(LeastSquares, OutliersCountLessWhereAskedFor) {
  const auto with_outlier = [](const Eigen::VectorXd& at) {
    Eigen::VectorXd left = decay(at);
    for (Eigen::Index k = 0; k < left.size(); ++k) left(k) += 1e-3 * std::sin(37.0 * static_cast<double>(k));
    left(3) += 1;
    return left;
  };
  const double plain = std::abs(least_squares({two, with_outlier}).value(0) - 3);
  LeastSquaresOptions options;
  options.robust_beyond = 0.1;
  EXPECT_LT(std::abs(least_squares({two, with_outlier}, options).value(0) - 3), 0.3 * plain);
}

TEST(LeastSquares, SeveralStartsLeaveALocalMinimum) {
  // Two minima, of which the one near 4 is deeper.
  const auto valleys = [](const Eigen::VectorXd& at) {
    Eigen::VectorXd left(1);
    const double x = at(0);
    left(0) = std::sqrt(0.2 * (x - 4) * (x - 4) + 1 + std::cos(3 * (x - 4) + 3.14159265358979));
    return left;
  };
  LeastSquaresOptions options;
  options.starts = 12;
  const LeastSquaresFit fit = least_squares({{{"x", 0.5, 0, 8, 1}}, valleys}, options);
  EXPECT_NEAR(fit.value(0), 4, 0.01);
  EXPECT_EQ(fit.starts, 12);
  EXPECT_GE(fit.agreeing, 1);
}

TEST(LeastSquares, ImpossibleValuesAreNotTakenAndAnImpossibleStartIsAnError) {
  const auto half = [](const Eigen::VectorXd& at) {
    if (at(0) > 3.5) throw ConfigError("too large");
    return decay(at);
  };
  EXPECT_NEAR(least_squares({two, half}).value(0), 3, 1e-6);
  const auto never = [](const Eigen::VectorXd&) -> Eigen::VectorXd { throw ConfigError("no"); };
  EXPECT_THROW(least_squares({two, never}), SolverError);
}

TEST(LeastSquares, AStopLeavesTheBestSoFar) {
  std::atomic<bool> stop = false;
  LeastSquaresOptions options;
  options.stop = &stop;
  options.starts = 5;
  int iterations = 0;
  double first = 0, last = 0;
  options.on_iteration = [&](int, int iteration, double cost) {
    (iteration == 0 ? first : last) = cost;
    stop = ++iterations == 2;
  };
  const LeastSquaresFit fit = least_squares({two, decay}, options);
  EXPECT_TRUE(fit.stopped);
  EXPECT_EQ(iterations, 2);
  ASSERT_EQ(fit.value.size(), 2);
  EXPECT_EQ(fit.cost, last);
  EXPECT_LT(fit.cost, first);
  EXPECT_EQ(fit.jacobian.rows(), fit.residuals.size());
  EXPECT_NEAR(0.5 * fit.residuals.squaredNorm(), fit.cost, 1e-12 * fit.cost);
}

TEST(LeastSquares, AStopDoesNotWaitForTheDerivatives) {
  std::atomic<bool> stop = false;
  std::atomic<int> evaluations = 0;
  LeastSquaresOptions options;
  options.stop = &stop;
  const auto stopped_at_once = [&](const Eigen::VectorXd& at) {
    if (++evaluations == 2) stop = true;  // the first evaluation for derivatives
    return decay(at);
  };
  const LeastSquaresFit fit = least_squares({two, stopped_at_once}, options);
  EXPECT_TRUE(fit.stopped);
  EXPECT_EQ(fit.value.size(), 0) << "nothing was found yet";
  EXPECT_LE(evaluations, 3) << "the other thread may have begun one";
}

}  // namespace
}  // namespace rubsweep::fit
