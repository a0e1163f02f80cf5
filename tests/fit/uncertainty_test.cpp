#include "rubsweep/fit/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/error.hpp"

namespace rubsweep::fit {
namespace {

/// A straight line a + b t at t = 0 .. 9 with residuals of +1, -1, ...
LeastSquaresFit line() {
  LeastSquaresFit fit;
  fit.value = Eigen::Vector2d(1, 2);
  fit.jacobian.resize(10, 2);
  fit.residuals.resize(10);
  for (Eigen::Index k = 0; k < 10; ++k) {
    fit.jacobian.row(k) << 1, static_cast<double>(k);
    fit.residuals(k) = k % 2 == 0 ? 1 : -1;
  }
  return fit;
}

TEST(Uncertainty, AStraightLineHasTheErrorsOfTextbooks) {
  const Uncertainty found = uncertainty_of(line(), 0);
  const double variance = 10.0 / 8, spread = 82.5;
  EXPECT_EQ(found.degrees_of_freedom, 8);
  EXPECT_NEAR(found.standard_error(1), std::sqrt(variance / spread), 1e-12);
  EXPECT_NEAR(found.standard_error(0), std::sqrt(variance * (0.1 + 4.5 * 4.5 / spread)), 1e-12);
  EXPECT_NEAR(found.correlation(0, 1), -4.5 / std::sqrt(28.5), 1e-12);
  EXPECT_NEAR(found.half_width(1) / found.standard_error(1), 2.3060, 1e-4);  // eight degrees of freedom
  EXPECT_THROW(uncertainty_of(line(), 8), ConfigError);
  EXPECT_TRUE(untold_combinations(found, {{"a"}, {"b"}}).empty());
}

TEST(Uncertainty, CombinationsThatDataDoNotTellAreNamed) {
  LeastSquaresFit fit = line();
  fit.value = Eigen::Vector3d(1, 2, 3);
  fit.jacobian.conservativeResize(10, 3);
  fit.jacobian.col(2) = 5 * fit.jacobian.col(1);
  const auto sentences = untold_combinations(uncertainty_of(fit, 0), {{"a"}, {"b"}, {"c"}});
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("b, c"), std::string::npos);
  fit.jacobian.col(2).setZero();
  const auto alone =
      untold_combinations(uncertainty_of(fit, 0), {{"a", 1, 0, 9}, {"b", 2, 0, 9}, {"c", 3, 0, 9}});
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone[0], "the data do not tell c");
  fit = line();
  const auto narrow = untold_combinations(uncertainty_of(fit, 0), {{"a", 1, 0, 9}, {"b", 2, 1.99, 2.01}});
  EXPECT_EQ(narrow, std::vector<std::string>{"the data do not tell b"});
}

}  // namespace
}  // namespace rubsweep::fit
