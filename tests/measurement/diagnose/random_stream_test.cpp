#include "rubsweep/measurement/diagnose/random_stream.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace rubsweep::diagnose {
namespace {

TEST(RandomStream, DependsOnItsThreeNumbersAlone) {
  RandomStream one(1, 2, 3), same(1, 2, 3);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(one.bits(), same.bits());
  std::set<std::uint64_t> firsts;
  for (std::uint64_t a = 0; a < 10; ++a)
    for (std::uint64_t b = 0; b < 10; ++b)
      for (std::uint64_t c = 0; c < 10; ++c) firsts.insert(RandomStream(a, b, c).bits());
  EXPECT_EQ(firsts.size(), 1000u);
}

TEST(RandomStream, UniformNumbersHaveTheMomentsOfTheUnitInterval) {
  RandomStream random(7, 0, 0);
  constexpr int count = 100000;
  double sum = 0, squares = 0;
  for (int k = 0; k < count; ++k) {
    const double u = random.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += u * u;
  }
  // Tolerance: four standard errors.
  EXPECT_NEAR(sum / count, 0.5, 4 * std::sqrt(1.0 / 12 / count));
  EXPECT_NEAR(squares / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
}

TEST(RandomStream, NormalNumbersLieWhereTheErrorFunctionPutsThem) {
  RandomStream random(8, 0, 0);
  constexpr int count = 100000;
  for (const double bound : {-1.5, 0.0, 1.0}) {
    int below = 0;
    for (int k = 0; k < count; ++k) below += random.normal() < bound;
    const double expected = std::erfc(-bound / std::sqrt(2.0)) / 2;
    EXPECT_NEAR(static_cast<double>(below) / count, expected,
                4 * std::sqrt(expected * (1 - expected) / count));
  }
}

TEST(RandomStream, StreamsOfNeighbouringIndicesAreNotRelated) {
  constexpr int count = 20000;
  double product = 0;
  for (std::uint64_t index = 0; index < count; ++index)
    product += (RandomStream(1, index, 0).uniform() - 0.5) * (RandomStream(1, index + 1, 0).uniform() - 0.5);
  EXPECT_NEAR(product / count, 0, 4 / 12.0 / std::sqrt(count));
}

TEST(RandomStreamPriorSpread, HalfOfTheProbabilityLiesBelowTheMiddle) {
  EXPECT_DOUBLE_EQ(value_at({2, 8, false}, 0.5), 5);
  EXPECT_DOUBLE_EQ(value_at({2, 8, true}, 0.5), 4);
}

TEST(RandomStreamPriorSpread, ReachesFromBoundToBound) {
  for (const bool logarithmic : {false, true}) {
    EXPECT_DOUBLE_EQ(value_at({2, 8, logarithmic}, 0), 2);
    EXPECT_DOUBLE_EQ(value_at({2, 8, logarithmic}, 1), 8);
  }
}

TEST(RandomStreamPriorSpread, MayGiveItsLowerBoundAProbabilityOfItsOwn) {
  const Spread spread{1, 1.5, false, 0.6};
  EXPECT_EQ(value_at(spread, 0), 1);
  EXPECT_EQ(value_at(spread, 0.599), 1);
  EXPECT_DOUBLE_EQ(value_at(spread, 0.8), 1.25);
  EXPECT_DOUBLE_EQ(value_at(spread, 1), 1.5);
}

TEST(RandomStreamPriorSpread, OfEqualBoundsIsKnown) { EXPECT_EQ(value_at({0, 0, true}, 0.3), 0); }

}  // namespace
}  // namespace rubsweep::diagnose
