#include "rubsweep/maps/batch/axis.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::batch {
namespace {

TEST(AxisEvenlySpaced, WholeNumbersStayWhole) {
  const auto speeds = evenly_spaced(45, 240, 66);
  ASSERT_EQ(speeds.size(), 66u);
  for (std::size_t i = 0; i < speeds.size(); ++i) EXPECT_EQ(speeds[i], 45.0 + 3.0 * static_cast<double>(i));
}

TEST(AxisEvenlySpaced, EndPointsAreExactAndNothingLiesOutside) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> value(-3, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    const double from = value(random), to = trial % 5 == 0 ? from : value(random);
    const auto values = evenly_spaced(from, to, 2 + trial % 40);
    EXPECT_EQ(values.front(), from);
    EXPECT_EQ(values.back(), to);
    const double step = (to - from) / static_cast<double>(values.size() - 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], from + step * static_cast<double>(i), 1e-14);
      EXPECT_LE(values[i], std::max(from, to));
      EXPECT_GE(values[i], std::min(from, to));
    }
  }
}

TEST(AxisEvenlySpaced, CountOfOneGivesTheFirst) { EXPECT_EQ(evenly_spaced(3, 7, 1), std::vector<double>{3}); }

TEST(AxisEvenlySpaced, NoValuesIsAnError) {
  EXPECT_EQ(message_of<ConfigError>([] { evenly_spaced(3, 7, 0); }),
            "count: 0 is out of range, allowed: a number >= 1");
}

TEST(AxisDecimalSteps, AreTheDoublesNearestToTheirDecimals) {
  const auto values = decimal_steps(30, 60, 0.1);
  ASSERT_EQ(values.size(), 301u);
  for (int i = 0; i <= 300; ++i) {
    const std::string decimal =
        std::to_string(30 + i / 10) + (i % 10 == 0 ? "" : "." + std::to_string(i % 10));
    EXPECT_EQ(values[static_cast<std::size_t>(i)], std::strtod(decimal.c_str(), nullptr));
    EXPECT_EQ(csv_number(values[static_cast<std::size_t>(i)]), decimal);
  }
}

TEST(AxisDecimalSteps, GoDownwardThroughZeroAndByPowersOfTen) {
  EXPECT_EQ(decimal_steps(0.3, -0.3, 0.1), (std::vector<double>{0.3, 0.2, 0.1, 0, -0.1, -0.2, -0.3}));
  EXPECT_EQ(decimal_steps(0, 3e-5, 1e-5), (std::vector<double>{0, 1e-5, 2e-5, 3e-5}));
  EXPECT_EQ(decimal_steps(1e20, 3e20, 1e20), (std::vector<double>{1e20, 2e20, 3e20}));
  EXPECT_EQ(decimal_steps(0, 200, 50), (std::vector<double>{0, 50, 100, 150, 200}));
  EXPECT_EQ(decimal_steps(7, 7, 0.5), std::vector<double>{7});
}

TEST(AxisDecimalSteps, AreCountedInDecimals) {
  EXPECT_EQ(whole_steps(30, 31, 0.1), 10);
  EXPECT_EQ(whole_steps(0.1, 0.9, 0.05), 16);
  EXPECT_EQ(whole_steps(0.1, 0.9, 0.3), std::nullopt);
  EXPECT_EQ(whole_steps(0, 1, 0), std::nullopt);
  EXPECT_EQ(whole_steps(0, 1, -0.1), std::nullopt);
  EXPECT_THROW(decimal_steps(0.1, 0.9, 0.3), std::invalid_argument);
}

TEST(AxisDecimalSteps, ThatMissTheEndLieBesideIt) {
  EXPECT_EQ(steps_beside(0.1, 0.9, 0.3), std::pair(0.7, 1.0));
  EXPECT_EQ(steps_beside(60, 30, 8), std::pair(36.0, 28.0));
  EXPECT_EQ(steps_beside(1.0 / 3, 1, 0.1), std::nullopt);
}

TEST(AxisDecimalSteps, SpanNoMoreDigitsThanADoubleHolds) {
  EXPECT_EQ(whole_steps(1, 2, 1e-14), 100'000'000'000'000);
  EXPECT_EQ(whole_steps(1, 2, 1e-15), std::nullopt);
  EXPECT_EQ(whole_steps(1.0 / 3, 1, 0.1), std::nullopt);
  EXPECT_EQ(whole_steps(0, 1e-25, 1e-26), std::nullopt);
  EXPECT_EQ(whole_steps(0, 1e300, 1), std::nullopt);
}

}  // namespace
}  // namespace rubsweep::batch
