#include "rubsweep/measurement/diagnose/drawn_machine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <variant>

#include "light_kit.hpp"

namespace rubsweep::diagnose {
namespace {

using std::numbers::pi;

Point middle_of(Cause cause) {
  Candidate candidate = usual_candidate(cause);
  spread_of(candidate, Unknown::natural_frequency) = {30, 30};
  spread_of(candidate, Unknown::damping_ratio) = {0.02, 0.02};
  Point unit{};
  unit.fill(0.5);
  return values_at(candidate, unit);
}

const FixedNumbers fixed{.rotor_mass_kg = 0.8};

TEST(DrawnMachine, EveryCauseGivesAMachineThatIsAllowed) {
  for (const Cause cause : all_causes)
    EXPECT_NO_THROW(model::validate(drawn_machine(cause, middle_of(cause), 1e-4, fixed))) << to_string(cause);
}

TEST(DrawnMachine, KickGivesTheRotorTheSpeedThatItsRatioSays) {
  const Point values = middle_of(Cause::one_side);
  const model::Machine machine = drawn_machine(Cause::one_side, values, 1e-4, fixed);
  // Impulse of the half sine by numerical integration.
  double impulse = 0;
  constexpr int steps = 10000;
  for (int k = 0; k < steps; ++k)
    impulse += machine.kick->force_n * std::sin(pi * (k + 0.5) / steps) * machine.kick->duration_s / steps;
  EXPECT_NEAR(impulse / fixed.rotor_mass_kg, value_of(values, Unknown::kick_ratio) * 1e-4 * 2 * pi * 30,
              1e-9);
}

TEST(DrawnMachine, TwoStopsFaceEachOther) {
  const Point values = middle_of(Cause::two_sides);
  const model::Machine machine = drawn_machine(Cause::two_sides, values, 1e-4, fixed);
  ASSERT_EQ(machine.stops.size(), 2u);
  EXPECT_EQ(std::get<model::OneSideGeometry>(machine.stops[0].geometry).angle_deg, 0);
  EXPECT_EQ(std::get<model::OneSideGeometry>(machine.stops[1].geometry).angle_deg, 180);
  EXPECT_NEAR(machine.stops[1].clearance_m / machine.stops[0].clearance_m,
              value_of(values, Unknown::second_clearance_ratio), 1e-12);
}

TEST(DrawnMachine, AnExponentLeavesTheStiffnessAtATwentiethOfTheClearance) {
  Point values = middle_of(Cause::two_sides);
  const double stiffness = value_of(values, Unknown::stiffness), clearance_m = 2e-4;
  EXPECT_EQ(value_of(values, Unknown::exponent), 1);
  EXPECT_TRUE(drawn_machine(Cause::two_sides, values, clearance_m, fixed).stops[1].law.linear());
  for (const double exponent : {1.2, 1.5}) {
    values[std::size_t(Unknown::exponent)] = exponent;
    const model::Machine machine = drawn_machine(Cause::two_sides, values, clearance_m, fixed);
    EXPECT_NO_THROW(model::validate(machine));
    for (const model::Stop& stop : machine.stops) {
      EXPECT_EQ(stop.law.exponent, exponent);
      const double at_m = clearance_m / 20,
                   force_n = stop.law.stiffness_n_per_m_n * std::pow(at_m, stop.law.exponent);
      EXPECT_NEAR(force_n / (stiffness * at_m), 1, 1e-12);
      // The depth that this force has, and twice as deep.
      EXPECT_NEAR(penetration_ratio(Cause::one_side, values, clearance_m, force_n), 0.05, 1e-12);
      EXPECT_NEAR(penetration_ratio(Cause::one_side, values, clearance_m, std::pow(2, exponent) * force_n),
                  0.1, 1e-12);
      EXPECT_NEAR(force_at_penetration_n(Cause::one_side, values, clearance_m, 0.05) / force_n, 1, 1e-12);
    }
  }
}

TEST(DrawnMachine, OffsetStandsInTheDirectionOfTheStop) {
  const Point values = middle_of(Cause::annular_offset);
  const model::Machine machine = drawn_machine(Cause::annular_offset, values, 1e-4, fixed);
  const auto& geometry = std::get<model::AnnularGeometry>(machine.stops.front().geometry);
  EXPECT_NEAR(geometry.offset_m[0], 1e-4 * value_of(values, Unknown::offset_ratio), 1e-18);
  EXPECT_EQ(geometry.offset_m[1], 0);
}

TEST(DrawnMachine, StopsOfAKitStandWhereTheyAreDrawn) {
  FixedNumbers of_kit = fixed;
  of_kit.kit = std::make_shared<KnownKit>(known_kit({light_kit()}, 40, "kit.yaml"));
  for (const Cause cause : all_causes) {
    Point values = middle_of(cause);
    values[static_cast<std::size_t>(Unknown::position)] = 0.11;
    values[static_cast<std::size_t>(Unknown::stop_angle)] = 60;
    const model::Machine machine = drawn_machine(cause, values, 1e-4, of_kit);
    EXPECT_NO_THROW(model::validate(machine)) << to_string(cause);
    for (const model::Stop& stop : machine.stops)
      EXPECT_EQ(stop.position_m, cause == Cause::no_rub ? 0.15 : 0.11);
    if (cause == Cause::one_side) {
      EXPECT_EQ(std::get<model::OneSideGeometry>(machine.stops[0].geometry).angle_deg, 60);
    }
    if (cause == Cause::annular_offset) {
      const auto& offset = std::get<model::AnnularGeometry>(machine.stops[0].geometry).offset_m;
      EXPECT_NEAR(std::atan2(offset[1], offset[0]) * 180 / pi, 60, 1e-9);
    }
  }
}

TEST(DrawnMachine, NothingStartsARotorWithoutAStop) {
  EXPECT_FALSE(drawn_machine(Cause::no_rub, middle_of(Cause::no_rub), 1e-4, fixed).kick);
}

}  // namespace
}  // namespace rubsweep::diagnose
