#include "rubsweep/core/response/proof/period_search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace rubsweep::response::proof {
namespace {

/// Turns until the search first names a period, and that period.
std::pair<int, int> first_candidate(const std::function<double(int)>& x, bool touched = true) {
  PeriodSearch search(1, 12);
  for (int turn = 0; turn < 300; ++turn) {
    const double section = x(turn);
    search.add({&section, 1}, touched);
    if (const auto order = search.candidate()) return {turn, *order};
  }
  return {-1, 0};
}

double decaying(int turn, int order) { return 0.3 * (turn % order) + 0.5 * std::pow(0.9, turn); }

TEST(PeriodSearch, NamesThePeriodOfADecayingTransient) {
  for (const int order : {1, 2, 3, 7, 12}) {
    const auto [turn, found] = first_candidate([=](int t) { return decaying(t, order); });
    EXPECT_EQ(found, order);
    EXPECT_GT(turn, order);
    EXPECT_LT(turn, 60);
  }
}

TEST(PeriodSearch, AMotionThatLeavesAPeriodicOneIsNoCandidate) {
  const auto leaving = [](int t) { return 0.3 * (t % 2) + 1e-9 * std::pow(1.05, t); };
  EXPECT_EQ(first_candidate(leaving).second, 0);
}

TEST(PeriodSearch, ContactOncePerPeriodIsEnough) {
  const auto always = first_candidate([](int t) { return decaying(t, 3); });
  PeriodSearch search(1, 12);
  for (int turn = 0; turn <= always.first; ++turn) {
    const double section = decaying(turn, 3);
    search.add({&section, 1}, turn % 3 == (always.first + 1) % 3);
    const auto order = search.candidate();
    EXPECT_EQ(order.value_or(0), turn == always.first ? 3 : 0) << turn;
  }
}

TEST(PeriodSearch, WithoutContactThereIsNothingToProve) {
  EXPECT_EQ(first_candidate([](int t) { return decaying(t, 2); }, false).second, 0);
}

TEST(PeriodSearch, AfterARefusalItWaits) {
  PeriodSearch search(1, 12);
  int asked = 0;
  for (int turn = 0; turn < 400; ++turn) {
    const double section = decaying(turn, 2);
    search.add({&section, 1}, true);
    if (const auto order = search.candidate()) {
      search.refuse(*order);
      ++asked;
    }
  }
  EXPECT_GT(asked, 3);
  EXPECT_LT(asked, 40);
}

TEST(PeriodSearch, ARotationByTheGoldenAngleComesBackToNoOrder) {
  PeriodSearch search(2, 12);
  for (int turn = 0; turn < 300; ++turn) {
    const double angle = 2.39996322972865332 * turn;
    const std::array<double, 2> section{std::cos(angle), std::sin(angle)};
    search.add(section, true);
    EXPECT_FALSE(search.candidate()) << turn;
  }
}

}  // namespace
}  // namespace rubsweep::response::proof
