#include "rubsweep/analysis/design/unbalance_response.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "analysis/design/amplification.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/table_machine.hpp"

namespace rubsweep::design {
namespace {

using namespace std::complex_literals;
using Complex = std::complex<double>;

double major_axis_at(const scene::QuietMotion& motion, const WatchedPlace& place) {
  return major_axis(place.map.cast<Complex>() * motion.amplitude);
}

/// Quiet whirl of a Jeffcott rotor of 50 Hz: its maximum 1 / (2 zeta sqrt(1 - zeta^2)) is at the speed ratio
/// 1 / sqrt(1 - 2 zeta^2).
TEST(UnbalanceResponseLargestOverSpeed, FindsAResonanceAThousandTimesNarrowerThanTheSteps) {
  for (const double zeta : {0.1, 1e-3, 1e-6}) {
    const SpeedRange range{1, 173};
    const linear::CriticalSpeed critical{1, 50 * std::sqrt(1 - zeta * zeta), zeta, 1};
    const auto speeds = response_speeds(range, std::vector{critical});
    EXPECT_TRUE(std::ranges::is_sorted(speeds));
    EXPECT_EQ(speeds.front(), 1);
    EXPECT_EQ(speeds.back(), 173);
    const Largest found = largest_over_speed(speeds, [&](double hz) { return amplification(hz / 50, zeta); });
    EXPECT_NEAR(found.speed_hz, 50 / std::sqrt(1 - 2 * zeta * zeta), 1e-5 * (1 + zeta)) << zeta;
    const double expected = 1 / (2 * zeta * std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(found.value, expected, 1e-9 * expected) << zeta;
  }
}

TEST(UnbalanceResponseLargestOverSpeed, IsAtAnEndWhereThereIsNoPeak) {
  const std::vector<double> speeds{1, 2, 3};
  EXPECT_EQ(largest_over_speed(speeds, [](double hz) { return hz; }).speed_hz, 3);
  EXPECT_EQ(largest_over_speed(speeds, [](double hz) { return -hz; }).speed_hz, 1);
}

TEST(UnbalanceResponseLargestOverSpeed, MayStandBetweenAnEndAndItsNeighbour) {
  const std::vector<double> speeds{1, 2, 3};
  for (const double top : {1.1, 2.9}) {
    const Largest found = largest_over_speed(speeds, [&](double hz) { return 5 - (hz - top) * (hz - top); });
    EXPECT_NEAR(found.speed_hz, top, 1e-6);
    EXPECT_NEAR(found.value, 5, 1e-12);
  }
}

TEST(UnbalanceResponseLargestOverSpeed, WhatIsNotFiniteIsInfinite) {
  const std::vector<double> speeds{1, 2, 3};
  const Largest found = largest_over_speed(
      speeds, [](double hz) { return hz == 2 ? std::numeric_limits<double>::quiet_NaN() : 1e300; });
  EXPECT_EQ(found.speed_hz, 2);
  EXPECT_TRUE(std::isinf(found.value));
}

TEST(UnbalanceResponse, OfAJeffcottRotorIsACircleOfItsClosedForm) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  for (const double hz : {10.0, 29.0, 30.0, 80.0}) {
    const scene::QuietMotion motion = unit_response(prepared, hz);
    const double diameter = 2 * amplification(hz / 30, 0.02);
    EXPECT_NEAR(major_axis_at(motion, probe_places(prepared).at(0)), diameter, 1e-9 * diameter) << hz;
    EXPECT_NEAR(major_axis_at(motion, stop_places(prepared).at(0)), diameter, 1e-9 * diameter) << hz;
  }
}

TEST(UnbalanceResponse, ProbesAtOnePlaceAreOne) {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  EXPECT_EQ(probe_places(scene::prepare_machine(machine)).size(), 1u) << "the rotor itself";
  kit.sensors = {
      {.position_m = 0.1, .angle_deg = 0}, {.position_m = 0.1, .angle_deg = 90}, {.position_m = 0.3}};
  kit.sensors[0].name = "DE x";
  kit.sensors[1].name = "DE y";
  const auto places = probe_places(scene::prepare_machine(machine));
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].position_m, 0.1);
  EXPECT_EQ(places[0].name, "DE x, DE y");
  EXPECT_EQ(places[1].position_m, 0.3);
  EXPECT_EQ(places[1].name, "");
}

/// Compares mode shapes common to all speeds with a separate reduction for each speed.
TEST(UnbalanceResponse, OfATableIsThatOfTheNumbersTypedIn) {
  model::Machine by_table = scene::table_machine(4);
  model::kit_of(by_table)->damping_ratio = {0};
  const scene::PreparedMachine prepared = scene::prepare_machine(by_table);
  for (std::size_t row = 0; row < scene::table_speeds_hz.size(); ++row) {
    model::Machine typed = scene::typed_machine(row, 6);
    model::kit_of(typed)->damping_ratio = {0};
    const scene::PreparedMachine there = scene::prepare_machine(typed);
    const double hz = scene::table_speeds_hz[row];
    const double expected = major_axis_at(unit_response(there, hz), stop_places(there)[0]);
    EXPECT_NEAR(major_axis_at(unit_response(prepared, hz), stop_places(prepared)[0]), expected,
                5e-4 * expected)
        << hz;
  }
}

/// Twice the largest distance from the centre over a turn.
double traced_axis(const Eigen::Vector2cd& amplitude) {
  double farthest = 0;
  for (int k = 0; k < 20000; ++k) {
    const Complex turned = std::polar(1.0, 2 * std::numbers::pi * k / 20000);
    farthest = std::max(farthest, std::hypot((amplitude(0) * turned).real(), (amplitude(1) * turned).real()));
  }
  return 2 * farthest;
}

TEST(UnbalanceResponse, AxisOfACircleIsItsDiameter) {
  EXPECT_DOUBLE_EQ(major_axis({3.0, -3.0i}), 6);
  EXPECT_DOUBLE_EQ(major_axis({3.0, 3.0i}), 6) << "backward";
}

/// The major axis equals neither the peak-to-peak value 2 of x nor that of y.
TEST(UnbalanceResponse, AxisOfALeaningLineIsLongerThanItsShadows) {
  EXPECT_NEAR(major_axis({1.0, 1.0}), 2 * std::sqrt(2), 1e-15);
  EXPECT_NEAR(major_axis({3.0i, 4.0i}), 10, 1e-14);
}

TEST(UnbalanceResponse, AxisIsThatOfTheTracedOrbit) {
  for (const Complex y : {Complex(0.2, 0.9), Complex(-1.4, 0.3), Complex(0.05, -0.6), Complex(0, 0)}) {
    const Eigen::Vector2cd amplitude(Complex(0.7, -0.4), y);
    EXPECT_NEAR(major_axis(amplitude), traced_axis(amplitude), 1e-6) << y;
  }
}

}  // namespace
}  // namespace rubsweep::design
