#include "rubsweep/maps/basin/low_discrepancy.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/error.hpp"

namespace rubsweep::basin {
namespace {

TEST(LowDiscrepancy, BeginsWithTheMirroredDigits) {
  EXPECT_EQ(low_discrepancy_point(0, 2), (std::vector<double>{0.5, 1.0 / 3}));
  EXPECT_EQ(low_discrepancy_point(1, 1), std::vector<double>{0.25});
  EXPECT_EQ(low_discrepancy_point(2, 1), std::vector<double>{0.75});
  EXPECT_NEAR(low_discrepancy_point(3, 2)[1], 1.0 / 9 + 1.0 / 3, 1e-15);  // 4 is 11 in base 3
}

TEST(LowDiscrepancy, CountsAQuarterDiscBetterThanItsStandardError) {
  constexpr std::size_t samples = 4000;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto point = low_discrepancy_point(i, 2);
    if (point[0] * point[0] + point[1] * point[1] < 1) ++inside;
  }
  const double share = fraction(inside, samples);
  EXPECT_NEAR(share, 0.7853981633974483, 0.5 * standard_error(share, samples));
}

TEST(LowDiscrepancy, HasAsManyDimensionsAsPrimes) {
  EXPECT_EQ(low_discrepancy_point(5, most_dimensions).size(), most_dimensions);
  EXPECT_THROW(low_discrepancy_point(5, most_dimensions + 1), ConfigError);
}

TEST(LowDiscrepancyFraction, HasItsStandardError) {
  EXPECT_EQ(fraction(1, 4), 0.25);
  EXPECT_NEAR(standard_error(0.5, 100), 0.05, 1e-15);
  EXPECT_EQ(standard_error(1, 100), 0);
}

}  // namespace
}  // namespace rubsweep::basin
