#include "rubsweep/response/proof/foretold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace rubsweep::response::proof {
namespace {

TEST(Foretold, AsksForReturnsInARowAndForHalfTheDistance) {
  Foretold foretold(3);
  foretold.add_told(0, 1, 0.9);
  foretold.add_told(0.009, 1, 0.9);
  EXPECT_FALSE(foretold.holds(0.1, 1));
  foretold.add_told(0.011, 1, 0.9);  // more than a tenth of the tenth that a return gains
  foretold.add_told(0, 1, 0.9);
  foretold.add_told(0, 1, 0.9);
  EXPECT_FALSE(foretold.holds(0.1, 1));
  foretold.add_told(0, 1, 0.9);
  EXPECT_TRUE(foretold.holds(0.49, 1));
  EXPECT_FALSE(foretold.holds(0.51, 1));
}

/// The slow direction of an orbit beside a fold, x' = c x - a x^2: the unstable orbit is at -(1 - c) / a.
/// Follows it from `x`; after how many returns, of `most`, the approach is foretold, and what is left then.
struct Fold {
  double contraction = 0.995, bend = 1;

  std::pair<int, double> follow(double x, int most) const {
    Foretold foretold(3);
    const double first = std::abs(x);
    for (int k = 1; k <= most; ++k) {
      const double next = contraction * x - bend * x * x;
      foretold.add_told(std::abs(next - contraction * x), std::abs(x), contraction);
      foretold.add_gain(std::abs(x), std::abs(next), contraction);
      x = next;
      if (foretold.holds(std::abs(x), first)) return {k, std::abs(x)};
    }
    return {most, std::abs(x)};
  }
};

TEST(Foretold, BesideAFoldAGainThatLastsIsEnough) {
  const Fold fold;
  // From the side that the orbit draws from, long before a tenth of the gain is told (below 5e-4).
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

}  // namespace
}  // namespace rubsweep::response::proof
