#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rubsweep::integrate::exact::tube {
namespace {

/// One mode change at half time, whose guard rises at rate s = 2 where the tube has width 1. With the radius
/// r, the guard differs by at most D = r / 0.9.
TurnTube one_change() {
  TurnTube tube;
  tube.period_s = 1;
  TurnTube::Switch change;
  change.time_s = 0.5;
  change.rate = change.lowest_rate = 2;
  change.spread.width.fast = 1;
  change.longest_window_s = 1;
  tube.switches.push_back(change);
  tube.deflections.push_back({{3}, {}});
  return tube;
}

double largest_radius(const TurnTube& tube) {
  double radius = 16;
  while (radius > 1e-9 && !tube.holds({radius})) radius /= 1.001;
  return radius;
}

TEST(TurnTube, ATurnWithoutChangesHoldsByItsMargins) {
  TurnTube tube;
  tube.period_s = 1;
  tube.margins.push_back({0.5, {{2}, {}}});
  EXPECT_TRUE(tube.holds({0.249}));
  EXPECT_FALSE(tube.holds({0.251}));
  EXPECT_EQ(tube.deviation({0.249}).fast, 0);
  EXPECT_EQ(tube.deviation({0.251}).fast, std::numeric_limits<double>::infinity());
}

/// The deviation is 3 x 1.05 D^2 / s, quadratic in the radius.
TEST(TurnTube, DeviationIsTheIntegralOfTheGuardWhileModesDiffer) {
  const TurnTube tube = one_change();
  const double distance = 1e-3 / 0.9;
  EXPECT_NEAR(tube.deviation({1e-3}).fast, 3 * 1.05 * distance * distance / 2, 1e-15);
  EXPECT_NEAR(tube.deviation({2e-3}).fast / tube.deviation({1e-3}).fast, 4, 1e-12);
}

TEST(TurnTube, AWindowMustNotReachTheEndsOfTheTurn) {
  TurnTube tube = one_change();
  // The window 4 D / s reaches its limit 0.5.
  EXPECT_NEAR(largest_radius(tube), 0.225, 1e-3);
  tube.switches[0].time_s = 0.1;
  EXPECT_NEAR(largest_radius(tube), 0.045, 1e-3);
  tube.switches[0].time_s = 0.9;
  EXPECT_NEAR(largest_radius(tube), 0.045, 1e-3);
}

TEST(TurnTube, WindowsMustNotOverlap) {
  TurnTube tube = one_change();
  tube.switches.push_back(tube.switches[0]);
  tube.switches[1].time_s = 0.52;
  tube.deflections.push_back({{0}, {}});
  EXPECT_NEAR(largest_radius(tube), 0.02 / 2 * 0.45, 1e-4);
}

/// Each change alone makes the guard's rate fall below half of s, or makes its bounds invalid.
TEST(TurnTube, TheGuardMustRiseForTheWholeTube) {
  const double free = largest_radius(one_change());
  const auto with = [](auto change) {
    TurnTube tube = one_change();
    change(tube.switches[0]);
    return largest_radius(tube);
  };
  EXPECT_NEAR(with([](auto& at) { at.rate_spread.width.fast = 10; }), 0.1, 1e-3);
  EXPECT_LT(with([](auto& at) { at.curvature = 100; }), 0.1 * free);
  EXPECT_LT(with([](auto& at) { at.curvature_spread.width.fast = 1000; }), free / 3);
  EXPECT_LT(with([](auto& at) { at.own_deflection = 50; }), 0.1 * free);
  EXPECT_LT(with([](auto& at) { at.longest_window_s = 0.01; }), 0.1 * free);
  EXPECT_LT(with([](auto& at) { at.lowest_rate = 0.49; }), 1e-8);
}

TEST(TurnTube, NoOtherGuardComesToZeroInTheWindow) {
  const double free = largest_radius(one_change());
  const auto with = [](auto change) {
    TurnTube tube = one_change();
    TurnTube::Other other;
    other.value = -0.01;
    change(other);
    tube.switches[0].others.push_back(other);
    return largest_radius(tube);
  };
  EXPECT_NEAR(with([](auto&) {}), free, 1e-9);
  EXPECT_NEAR(with([](auto& other) { other.spread.width.fast = 1; }), 0.01, 1e-4);
  EXPECT_NEAR(with([](auto& other) { other.rate = 1; }), 0.01 * 0.45, 1e-4);
  EXPECT_LT(with([](auto& other) { other.curvature = 100; }), 0.1 * free);
  EXPECT_LT(with([](auto& other) { other.rate_spread.width.fast = 100; }), 0.1 * free);
  EXPECT_LT(with([](auto& other) { other.curvature_spread.width.fast = 1e5; }), 0.1 * free);
  EXPECT_LT(with([](auto& other) { other.own_deflection = 100; }), 0.1 * free);
}

/// A disturbance deflected at the first change counts at the second change and in later margins.
TEST(TurnTube, DeflectionsWidenTheTubeBehindThem) {
  TurnTube tube = one_change();
  tube.switches[0].margins_before = 0;
  tube.margins.push_back({0.01, {{}, {100, 0}}});
  const double distance = largest_radius(tube) / 0.9;
  EXPECT_NEAR(100 * 1.05 * distance * distance / 2, 0.01, 1e-4);
  tube.margins.clear();
  tube.switches.push_back(tube.switches[0]);
  tube.switches[1].time_s = 0.9;
  tube.switches[1].spread = {{1}, {1000, 0}};
  tube.deflections.push_back({{1}, {}});
  const double radius = 1e-3, first = radius / 0.9, deflection = 1.05 * first * first / 2;
  const double second = (radius + 1000 * deflection) / 0.9;
  EXPECT_NEAR(tube.deviation({radius}).fast, 3 * deflection + 1.05 * second * second / 2, 1e-15);
}

/// A tube that is valid for one radius is valid for every smaller one.
TEST(TurnTube, SmallerTubesHoldToo) {
  TurnTube tube = one_change();
  tube.switches[0].curvature = 5;
  tube.margins.push_back({0.1, {{1}, {30, 2}}});
  const double radius = largest_radius(tube);
  for (int i = 1; i <= 100; ++i) EXPECT_TRUE(tube.holds({radius * i / 100}));
}

}  // namespace
}  // namespace rubsweep::integrate::exact::tube
