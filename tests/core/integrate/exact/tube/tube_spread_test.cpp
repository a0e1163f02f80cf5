#include "rubsweep/core/integrate/exact/tube/tube_spread.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::integrate::exact::tube {
namespace {

TEST(TubeSpreadOf, UnitDisturbancesAreOneLengthDeflectionsAreAlone) {
  const auto spread = spread_of({3, -4, 5, -6}, {2, 0});
  EXPECT_EQ(spread.width.fast, 5);
  EXPECT_EQ(spread.deflections, (std::vector<double>{5, 6}));
}

/// sin t and cos t, whose second derivatives are at most 1; the length of the vector is always 1.
TEST(TubeSpreadOver, BoundsWhatTheValuesDoInTheStep) {
  for (const double duration : {0.01, 0.1, 0.5}) {
    const auto spread = spread_over({{0, 1, 0}, {1, 0, 1}, {1, 1, 1}}, {2, 0}, duration);
    EXPECT_GE(spread.width.fast, 1);
    EXPECT_LE(spread.width.fast, std::hypot(1, duration) + std::sqrt(2) / 2 * duration * duration);
    EXPECT_GE(spread.deflections[0], std::sin(duration));
    EXPECT_LE(spread.deflections[0], duration + duration * duration / 2);
  }
}

TEST(TubeSpreadRaise, TakesTheLargerOfWhatBothHave) {
  TurnTube::Spread spread{{1, 7}, {2, 3}};
  raise(spread, {{4, 6}, {1, 5, 9}});
  EXPECT_EQ(spread.width.fast, 4);
  EXPECT_EQ(spread.width.slow, 7);
  EXPECT_EQ(spread.deflections, (std::vector<double>{2, 5}));
}

}  // namespace
}  // namespace rubsweep::integrate::exact::tube
