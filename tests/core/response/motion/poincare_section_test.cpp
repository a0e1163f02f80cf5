#include "rubsweep/core/response/motion/poincare_section.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::response::motion {
namespace {

constexpr int states = 3;
constexpr int turns = 64;

/// Rows that repeat after exactly n turns: the first state takes the values 0.1, 0.2, ... 0.1 n.
std::vector<double> periodic_rows(int n) {
  std::vector<double> rows;
  for (int k = 0; k <= turns; ++k) {
    const int phase = k % n;
    rows.insert(rows.end(), {0.1 * (phase + 1), -0.5, std::cos(1.0 + phase)});
  }
  return rows;
}

double& at(std::vector<double>& rows, int row, int state) {
  return rows[static_cast<std::size_t>(row * states + state)];
}

TEST(PoincareSection, FindsEveryPeriodUpToTheLargestOrder) {
  for (int n = 1; n <= 12; ++n) {
    const auto period = period_of_section(periodic_rows(n), states, 12);
    ASSERT_TRUE(period) << n;
    EXPECT_EQ(period->order, n);
    EXPECT_EQ(period->residual, 0);
  }
}

TEST(PoincareSection, LooksNoFurtherThanTheLargestOrder) {
  EXPECT_FALSE(period_of_section(periodic_rows(12), states, 11));
  EXPECT_FALSE(period_of_section(periodic_rows(13), states, 12));
  EXPECT_EQ(period_of_section(periodic_rows(13), states, 13)->order, 13);
}

TEST(PoincareSection, WindowOfAnOrderIsTheWholePeriodsThatFit) {
  EXPECT_EQ(window_turns(64, 1), 64);
  EXPECT_EQ(window_turns(64, 7), 63);
  EXPECT_EQ(window_turns(64, 11), 55);
  EXPECT_EQ(window_turns(6, 7), 0);
}

TEST(PoincareSection, ToleranceIsTenToTheMinusFiveAndTheResidualIsReported) {
  for (const int n : {1, 2, 7, 9, 11, 12}) {
    auto rows = periodic_rows(n);
    at(rows, 40, 2) += 5e-6;
    const auto period = period_of_section(rows, states, 12);
    ASSERT_TRUE(period) << n;
    EXPECT_EQ(period->order, n);
    EXPECT_NEAR(period->residual, 5e-6, 1e-15);

    at(rows, 40, 2) += 1.5e-5;
    EXPECT_FALSE(period_of_section(rows, states, 12)) << n;
  }
}

TEST(PoincareSection, OneRowAtEitherEndOfTheWindowIsEnoughToDenyAPeriod) {
  for (const int n : {2, 7, 12}) {
    for (const int row : {turns - window_turns(turns, n), turns}) {
      auto rows = periodic_rows(n);
      at(rows, row, 0) += 1e-3;
      EXPECT_FALSE(period_of_section(rows, states, 12)) << n << " row " << row;
    }
  }
}

TEST(PoincareSection, RowsBeforeTheWindowOfTheOrderDoNotCount) {
  for (const int n : {7, 9, 11, 12}) {
    auto rows = periodic_rows(n);
    for (int row = 0; row < turns - window_turns(turns, n); ++row) at(rows, row, 0) += 1e-3;
    const auto period = period_of_section(rows, states, 12);
    ASSERT_TRUE(period) << n;
    EXPECT_EQ(period->order, n);
  }
}

TEST(PoincareSection, ATransientThatOnlyAShorterWindowMissesGivesNoPeriod) {
  // Synchronous except for its first row: order 3 uses only 63 turns and would be accepted.
  auto synchronous = periodic_rows(1);
  at(synchronous, 0, 0) += 1e-3;
  EXPECT_FALSE(period_of_section(synchronous, states, 12));
  auto half = periodic_rows(2);
  at(half, 0, 0) += 1e-3;
  EXPECT_FALSE(period_of_section(half, states, 12));
}

TEST(PoincareSection, APeriodMustBeSeenTwice) {
  std::vector<double> rows;
  for (int k = 0; k <= 9; ++k) rows.push_back(k % 5);
  EXPECT_FALSE(period_of_section(rows, 1, 12));
  rows.push_back(0);
  EXPECT_EQ(period_of_section(rows, 1, 12)->order, 5);
}

TEST(PoincareSection, NumbersThatAreNotFiniteNeverReturn) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto rows = periodic_rows(1);
    at(rows, 50, 1) = bad;
    EXPECT_FALSE(period_of_section(rows, states, 12));
    EXPECT_FALSE(period_of_section(std::vector<double>(65, bad), 1, 12));
  }
}

TEST(PoincareSection, RefusesRowsThatHaveNoShape) {
  const std::vector<double> rows(10);
  EXPECT_THROW(period_of_section(rows, 3, 12), SolverError);
  EXPECT_THROW(period_of_section(rows, 0, 12), SolverError);
  EXPECT_THROW(period_of_section({}, 1, 12), SolverError);
}

TEST(PoincareSectionReturns, AfterItsOrderOnceEveryNumberIsWithinTheTolerance) {
  SectionReturns returns(2);
  EXPECT_FALSE(returns.returned({1, 5}));
  EXPECT_FALSE(returns.returned({1, 5}));  // the section one turn earlier
  EXPECT_FALSE(returns.returned({1, 5 + 2 * section_tolerance}));
  EXPECT_TRUE(returns.returned({1 - section_tolerance / 2, 5}));
  EXPECT_FALSE(returns.returned({2, 5 + 2 * section_tolerance}));
}

/// Rows that settle on a motion of n turns. The disturbance has the size `distance` at the start; in every
/// period it rotates by `angle` (as a fraction of a circle) and shrinks by `factor`.
std::vector<double> settling_rows(int n, double distance, double angle, double factor) {
  std::vector<double> rows = periodic_rows(n);
  for (int k = 0; k <= turns; ++k) {
    const int period = k / n;
    const double left = distance * std::pow(factor, period), turned = 2 * std::acos(-1.0) * angle * period;
    at(rows, k, 0) += left * std::cos(turned);
    at(rows, k, 2) += left * std::sin(turned);
  }
  return rows;
}

/// A multiplier m near -1 makes the return after two periods much closer than that after one: 1 - m^2
/// compared with 1 - m. Multipliers near other roots of unity do the same after more periods.
TEST(PoincareSection, ASlowApproachIsOfTheOrderThatItApproaches) {
  for (const auto& [n, multiple, left] : {std::tuple{4, 2, 0.3},
                                          {4, 2, 0.8},
                                          {3, 2, 0.3},
                                          {1, 2, 0.6},
                                          {2, 3, 0.3},
                                          {1, 5, 0.7},
                                          {2, 6, 0.3},
                                          {5, 2, 0.5}}) {
    const double factor = std::pow(left, static_cast<double>(n) / turns);
    const auto rows = settling_rows(n, 1.5e-5, 1.0 / multiple, factor);
    const auto period = period_of_section(rows, states, 12);
    ASSERT_TRUE(period) << n << " times " << multiple;
    EXPECT_EQ(period->order, n) << "times " << multiple;
    EXPECT_GT(period->residual, 0);
  }
}

TEST(PoincareSection, AnOrderOfItsOwnThatSettlesStaysWhatItIs) {
  for (const double factor : {0.2, 0.5, 0.9, 0.99}) {
    // The orbit of 8 turns differs from one of 4 turns by 3e-5, while the transient decays.
    auto rows = settling_rows(4, 5e-6, 0.5, std::pow(factor, 4.0 / turns));
    for (int k = 0; k <= turns; ++k) at(rows, k, 1) += k / 4 % 2 == 0 ? 3e-5 : -3e-5;
    const auto period = period_of_section(rows, states, 12);
    ASSERT_TRUE(period) << factor;
    EXPECT_EQ(period->order, 8) << factor;
  }
}

TEST(PoincareSection, AnApproachThatIsTooSlowToTellIsOfNoOrder) {
  for (const double factor : {0.94, 0.97, 0.99})
    EXPECT_FALSE(period_of_section(settling_rows(4, 2e-5, 0.5, std::pow(factor, 4.0 / turns)), states, 12))
        << factor;
}

}  // namespace
}  // namespace rubsweep::response::motion
