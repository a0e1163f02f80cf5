#include "rubsweep/core/response/proof/periodic_orbit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace rubsweep::response::proof {
namespace {

/// Number of turns until the search first suggests a period, and that period.
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

TEST(PeriodicOrbitPeriodSearch, NamesThePeriodOfADecayingTransient) {
  for (const int order : {1, 2, 3, 7, 12}) {
    const auto [turn, found] = first_candidate([=](int t) { return decaying(t, order); });
    EXPECT_EQ(found, order);
    EXPECT_GT(turn, order);
    EXPECT_LT(turn, 60);
  }
}

/// The sections kept go around in their memory several times.
TEST(PeriodicOrbitPeriodSearch, FindsAPeriodWheneverItBegins) {
  const auto at_once = first_candidate([](int t) { return decaying(t, 7); });
  for (int before = 1; before < 60; ++before) {
    const auto late = first_candidate([=](int t) { return t < before ? 10.0 + t : decaying(t - before, 7); });
    EXPECT_EQ(late.second, 7);
    EXPECT_EQ(late.first, before + at_once.first);
  }
}

TEST(PeriodicOrbitPeriodSearch, AMotionThatLeavesAPeriodicOneIsNoCandidate) {
  const auto leaving = [](int t) { return 0.3 * (t % 2) + 1e-9 * std::pow(1.05, t); };
  EXPECT_EQ(first_candidate(leaving).second, 0);
}

TEST(PeriodicOrbitPeriodSearch, ContactOncePerPeriodIsEnough) {
  const auto always = first_candidate([](int t) { return decaying(t, 3); });
  PeriodSearch search(1, 12);
  for (int turn = 0; turn <= always.first; ++turn) {
    const double section = decaying(turn, 3);
    search.add({&section, 1}, turn % 3 == (always.first + 1) % 3);
    const auto order = search.candidate();
    EXPECT_EQ(order.value_or(0), turn == always.first ? 3 : 0) << turn;
  }
}

TEST(PeriodicOrbitPeriodSearch, WithoutContactThereIsNothingToProve) {
  EXPECT_EQ(first_candidate([](int t) { return decaying(t, 2); }, false).second, 0);
}

TEST(PeriodicOrbitPeriodSearch, AfterARefusalItWaits) {
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

TEST(PeriodicOrbitPeriodSearch, ARotationByTheGoldenAngleComesBackToNoOrder) {
  PeriodSearch search(2, 12);
  for (int turn = 0; turn < 300; ++turn) {
    const double angle = 2.39996322972865332 * turn;
    const std::array<double, 2> section{std::cos(angle), std::sin(angle)};
    search.add(section, true);
    EXPECT_FALSE(search.candidate()) << turn;
  }
}

/// The logistic map, whose orbits and multipliers have closed forms.
TurnMap logistic(double r) {
  return [r](std::span<double> s, Eigen::MatrixXd* disturbances) {
    if (disturbances) *disturbances *= r * (1 - 2 * s[0]);
    s[0] = r * s[0] * (1 - s[0]);
    return true;
  };
}

double logistic_after(double r, double x, int turns) {
  for (int k = 0; k < turns; ++k) x = r * x * (1 - x);
  return x;
}

TEST(PeriodicOrbitFind, FixedPointWithItsMultiplier) {
  const double r = 2.8, section = logistic_after(r, 0.3, 12);
  const auto orbit = find_orbit(logistic(r), {&section, 1}, 1);
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->order, 1);
  EXPECT_NEAR(orbit->sections[0](0), 1 - 1 / r, 1e-11);
  EXPECT_NEAR(orbit->floquet_modulus, std::abs(2 - r), 1e-10);
}

TEST(PeriodicOrbitFind, TwoCycleWithItsMultiplier) {
  const double r = 3.3, section = logistic_after(r, 0.3, 40);
  const auto orbit = find_orbit(logistic(r), {&section, 1}, 2);
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->order, 2);
  EXPECT_NEAR(orbit->floquet_modulus, std::abs(4 + 2 * r - r * r), 1e-9);
}

TEST(PeriodicOrbitFind, FewerTurnsAreTheOrder) {
  const double section = logistic_after(2.8, 0.3, 30);
  const auto orbit = find_orbit(logistic(2.8), {&section, 1}, 6);
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->order, 1);
}

TEST(PeriodicOrbitFind, AnUnstableOrbitIsNoOrbit) {
  const double section = 1 - 1 / 3.3 + 1e-9;
  EXPECT_FALSE(find_orbit(logistic(3.3), {&section, 1}, 1));
}

/// First steps with slightly wrong derivatives lead to the same orbit; the derivative of the result is exact.
TEST(PeriodicOrbitFind, GoesByRoughDerivativesUntilItIsNear) {
  const double r = 2.8, error = 1e-6, section = 1 - 1 / r + 1e-2;
  int rough = 0, exact = 0;
  const TurnMap roughly = [&](std::span<double> s, Eigen::MatrixXd* disturbances) {
    if (disturbances) ++rough, *disturbances *= 1 + error;
    return logistic(r)(s, disturbances);
  };
  const TurnMap turn = [&](std::span<double> s, Eigen::MatrixXd* disturbances) {
    if (disturbances) ++exact;
    return logistic(r)(s, disturbances);
  };
  const auto orbit = find_orbit(turn, {&section, 1}, 1, &roughly);
  ASSERT_TRUE(orbit);
  EXPECT_NEAR(orbit->sections[0](0), 1 - 1 / r, 1e-15);
  EXPECT_NEAR(orbit->floquet_modulus, std::abs(2 - r), 1e-13);
  EXPECT_NEAR(orbit->transitions[0](0, 0), 2 - r, 1e-13);
  EXPECT_EQ(rough, 3);
  EXPECT_EQ(exact, 2);
  // A transient that is already on the orbit needs no first steps, but its derivative must be exact, too.
  rough = exact = 0;
  const double there = 1 - 1 / r;
  const auto at_once = find_orbit(turn, {&there, 1}, 1, &roughly);
  ASSERT_TRUE(at_once);
  EXPECT_NEAR(at_once->floquet_modulus, std::abs(2 - r), 1e-13);
  EXPECT_EQ(rough, 1);
  EXPECT_EQ(exact, 2);
}

/// A single evaluation is enough far from an orbit with a steep slope; no iteration down to rounding.
TEST(PeriodicOrbitFind, GivesUpWhereTheTransientStandsOnASteepSlope) {
  int derivatives = 0;
  const auto counted = [&](double r) {
    return TurnMap([&derivatives, map = logistic(r)](std::span<double> s, Eigen::MatrixXd* disturbances) {
      derivatives += disturbances != nullptr;
      return map(s, disturbances);
    });
  };
  const double steep = 1 - 1 / 3.3 + 1e-3, gentle = 1 - 1 / 3.05 + 1e-3;
  EXPECT_FALSE(find_orbit(counted(3.3), {&steep, 1}, 1));
  EXPECT_EQ(derivatives, 1);
  derivatives = 0;
  EXPECT_FALSE(find_orbit(counted(3.05), {&gentle, 1}, 1));
  EXPECT_EQ(derivatives, 2);
}

TEST(PeriodicOrbitFind, AMultiplierOnTheUnitCircleIsNoOrbit) {
  const TurnMap rotation = [](std::span<double> s, Eigen::MatrixXd* disturbances) {
    Eigen::Matrix2d turn;
    turn << std::cos(1), -std::sin(1), std::sin(1), std::cos(1);
    if (disturbances) *disturbances = turn * *disturbances;
    const Eigen::Vector2d x = turn * Eigen::Vector2d(s[0], s[1]);
    s[0] = x[0];
    s[1] = x[1];
    return true;
  };
  const std::array<double, 2> section{1e-3, 0};
  EXPECT_FALSE(find_orbit(rotation, section, 1));
}

TEST(PeriodicOrbitFind, ListsItsTurns) {
  const double r = 3.3, section = logistic_after(r, 0.3, 40);
  const auto orbit = find_orbit(logistic(r), {&section, 1}, 2);
  ASSERT_TRUE(orbit);
  ASSERT_EQ(orbit->sections.size(), 2);
  ASSERT_EQ(orbit->transitions.size(), 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const double x = orbit->sections[k](0);
    EXPECT_NEAR(orbit->sections[1 - k](0), r * x * (1 - x), 1e-11);
    EXPECT_NEAR(orbit->transitions[k](0, 0), r * (1 - 2 * x), 1e-10);
  }
}

TEST(PeriodicOrbitFind, AMapThatFailsIsNoOrbit) {
  const TurnMap broken = [](std::span<double>, Eigen::MatrixXd*) { return false; };
  const double section = 0;
  EXPECT_FALSE(find_orbit(broken, {&section, 1}, 1));
}

TEST(PeriodicOrbitDifferentiate, CentralDifferencesOfAMap) {
  const auto map = [](std::span<double> s) {
    const double x = s[0], y = s[1];
    s[0] = x * x * y;
    s[1] = std::sin(x) + y;
    return true;
  };
  std::array<double, 2> section{0.7, -0.4};
  Eigen::MatrixXd transition;
  ASSERT_TRUE(differentiate(map, section, 1e-5, transition));
  EXPECT_NEAR(transition(0, 0), 2 * 0.7 * -0.4, 1e-9);
  EXPECT_NEAR(transition(0, 1), 0.49, 1e-9);
  EXPECT_NEAR(transition(1, 0), std::cos(0.7), 1e-9);
  EXPECT_NEAR(transition(1, 1), 1, 1e-9);
  EXPECT_DOUBLE_EQ(section[0], 0.49 * -0.4);
}

}  // namespace

}  // namespace rubsweep::response::proof
