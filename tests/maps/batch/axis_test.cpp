#include "rubsweep/maps/batch/axis.hpp"

#include <gtest/gtest.h>

#include <random>

#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"

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

}  // namespace
}  // namespace rubsweep::batch
