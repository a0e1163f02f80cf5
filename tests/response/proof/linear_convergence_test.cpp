#include "rubsweep/response/proof/linear_convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <utility>

namespace rubsweep::response::proof {
namespace {

TEST(LinearConvergence, AsksForReturnsInARowAndForHalfTheDistance) {
  LinearConvergenceTest convergence(3);
  convergence.add_prediction(0, 1, 0.9);
  convergence.add_prediction(0.009, 1, 0.9);
  EXPECT_FALSE(convergence.passed(0.1, 1));
  convergence.add_prediction(0.011, 1, 0.9);  // more than a tenth of the tenth that a return gains
  convergence.add_prediction(0, 1, 0.9);
  convergence.add_prediction(0, 1, 0.9);
  EXPECT_FALSE(convergence.passed(0.1, 1));
  convergence.add_prediction(0, 1, 0.9);
  EXPECT_TRUE(convergence.passed(0.49, 1));
  EXPECT_FALSE(convergence.passed(0.51, 1));
}

/// The slow direction of an orbit beside a fold, x' = c x - a x^2: the unstable orbit is at -(1 - c) / a.
/// Follows it from `x`; after how many returns, of `most`, the test is passed, and what is left then.
struct Fold {
  double contraction = 0.995, bend = 1;

  std::pair<int, double> follow(double x, int most) const {
    LinearConvergenceTest convergence(3);
    const double first = std::abs(x);
    for (int k = 1; k <= most; ++k) {
      const double next = contraction * x - bend * x * x;
      convergence.add_prediction(std::abs(next - contraction * x), std::abs(x), contraction);
      convergence.add_contraction(std::abs(x), std::abs(next), contraction);
      x = next;
      if (convergence.passed(std::abs(x), first)) return {k, std::abs(x)};
    }
    return {most, std::abs(x)};
  }
};

TEST(LinearConvergence, BesideAFoldAGainThatLastsIsEnough) {
  const Fold fold;
  // From the side that the orbit draws from, long before a tenth of the gain is predicted (below 5e-4).
  const auto [returns, left] = fold.follow(0.1, 2000);
  EXPECT_GT(left, 1e-3);
  EXPECT_GE(returns, 138);  // ln 2 / 0.005
  EXPECT_LT(returns, 145);
  // From just before the unstable orbit the gain comes late, and so does the word.
  const auto [later, nearer] = fold.follow(-0.0049, 4000);
  EXPECT_GT(later, 400);
  EXPECT_LT(nearer, 5.1e-4);
  // And never from behind it.
  EXPECT_EQ(fold.follow(-0.0051, 600).first, 600);
}

/// Beside a torus bifurcation, z' = z (c + b |z|^2) e^{i (w + t |z|^2)}: the unstable torus is at |z|^2 =
/// (1 - c) / b, and with the distance changes the angle by which a return turns.
struct Spiral {
  double contraction = 0.995, bend = 0.5, twist = 3;

  /// Follows `most` returns from |z| = `distance`; how many are predicted, and after how many the approach
  /// is.
  std::pair<int, int> follow(double distance, int most) const {
    LinearConvergenceTest convergence(3);
    int predicted = 0;
    std::complex<double> z = distance;
    for (int k = 1; k <= most; ++k) {
      const double square = std::norm(z);
      const auto says = contraction * std::polar(1.0, 1.3) * z;
      const auto next = z * (contraction + bend * square) * std::polar(1.0, 1.3 + twist * square);
      const double error = std::abs(next - says);
      if (error <= 0.1 * (1 - contraction) * std::abs(z)) ++predicted;
      convergence.add_prediction(error, std::abs(z), contraction);
      convergence.add_contraction(std::abs(z), std::abs(next), contraction);
      z = next;
      if (convergence.passed(std::abs(z), distance)) return {predicted, k};
    }
    return {predicted, most};
  }
};

TEST(LinearConvergence, BesideATorusBifurcationATurnedApproachIsOne) {
  const auto [predicted, returns] = Spiral{}.follow(0.06, 2000);
  EXPECT_EQ(predicted, 0);
  EXPECT_GT(returns, 138);
  EXPECT_LT(returns, 500);
  // The torus is at 0.1: nothing comes from behind it.
  EXPECT_EQ(Spiral{}.follow(0.101, 2000), std::pair(0, 2000));
}

}  // namespace
}  // namespace rubsweep::response::proof
