#include "rubsweep/core/integrate/taylor/tangent_convergence.hpp"

#include <gtest/gtest.h>

namespace rubsweep::integrate::taylor {
namespace {

using Sizes = TangentConvergence<2>::Sizes;

TEST(TangentConvergence, TakesTwoSmallTermsInARowOfEachVector) {
  TangentConvergence<2> convergence(1e-3, Sizes(1, 1), Sizes(1, 1));
  const Sizes large(1, 1), first_small(1e-4, 1), both_small(1e-4, 1e-4);
  convergence.add(1, first_small, first_small);
  convergence.add(2, large, large);  // a single small term is not enough
  convergence.add(3, first_small, first_small);
  convergence.add(4, first_small, first_small);
  EXPECT_FALSE(convergence.all_converged());
  EXPECT_EQ(convergence.order(0, 9), 4);
  EXPECT_EQ(convergence.order(1, 9), 9);
  convergence.add(5, both_small, both_small);
  convergence.add(6, both_small, both_small);
  EXPECT_TRUE(convergence.all_converged());
  EXPECT_EQ(convergence.order(0, 9), 4);
  EXPECT_EQ(convergence.order(1, 9), 6);
}

TEST(TangentConvergence, HeedsDisplacementsAndRates) {
  const Sizes large(1, 1), small(1e-4, 1e-4);
  TangentConvergence<2> convergence(1e-3, large, large);
  for (int k = 1; k < 5; ++k) convergence.add(k, small, large);
  for (int k = 5; k < 9; ++k) convergence.add(k, large, small);
  EXPECT_FALSE(convergence.all_converged());
}

/// A term is small relative to the largest one, which may be any earlier term.
TEST(TangentConvergence, MeasuresByTheLargestTerm) {
  TangentConvergence<2> convergence(1e-3, Sizes(1, 1), Sizes(1, 1));
  convergence.add(1, Sizes(100, 1), Sizes(100, 1));
  convergence.add(2, Sizes(0.05, 0.05), Sizes(0.05, 0.05));
  convergence.add(3, Sizes(0.05, 0.05), Sizes(0.05, 0.05));
  EXPECT_EQ(convergence.order(0, 9), 3);
  EXPECT_EQ(convergence.order(1, 9), 9);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
