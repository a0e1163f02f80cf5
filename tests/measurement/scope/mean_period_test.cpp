#include "rubsweep/measurement/scope/mean_period.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;

TEST(MeanPeriod, TheLastWholePeriodsCount) {
  const std::vector<Complex> samples{9, 1, 2, 3, 5};
  const auto whole = whole_periods(samples, 2);
  ASSERT_EQ(whole.size(), 4u);
  EXPECT_EQ(mean_period(whole, 2), (std::vector<Complex>{2, 3.5}));
}

TEST(MeanPeriod, LinesAreThoseThatWerePutIn) {
  std::vector<Complex> period;
  for (int k = 0; k < 40; ++k) {
    const double phase = 2 * std::numbers::pi * k / 40;
    period.push_back(Complex(3, 1) + std::polar(2.0, 0.4 + 5 * phase) + std::polar(0.5, -1 - 3 * phase));
  }
  const auto lines = lines_of_period(period, 6);
  ASSERT_EQ(lines.size(), 13u);
  for (int k = -6; k <= 6; ++k) {
    const Complex truth = k == 0    ? Complex(3, 1)
                          : k == 5  ? std::polar(2.0, 0.4)
                          : k == -3 ? std::polar(0.5, -1.0)
                                    : 0;
    EXPECT_LT(std::abs(lines[static_cast<std::size_t>(k + 6)] - truth), 1e-14) << k;
  }
}

}  // namespace
}  // namespace rubsweep::scope
