#include "rubsweep/analysis/design/design_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/design/amplification.hpp"
#include "analysis/design/study_of.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {
namespace {

DesignCheck checked(const sweep::Study& study, const DesignQuestions& questions) {
  return check_design(study, scene::prepare_machine(study.machine), questions);
}

TEST(DesignCheck, OfAJeffcottRotorIsItsClosedForms) {
  const DesignCheck check = checked(study_of(scene::one_side_machine()), {{50, 160}, {}, 0, 1});
  const double eccentricity_m = 4 * 6350.0 / (160 * 60) * 1e-6;
  EXPECT_NEAR(check.eccentricity_m, eccentricity_m, 1e-18);
  EXPECT_EQ(check.vibration_limit_m, 25.4e-6) << "9600 rpm";
  const double probe_m = 2 * eccentricity_m * amplification(50 / 30.0, 0.02);
  EXPECT_NEAR(check.worst_probe().major_axis_m.value, probe_m, 1e-9 * probe_m)
      << "the critical speed is outside";
  EXPECT_NEAR(check.scale, 25.4e-6 / probe_m, 1e-9 * check.scale);
  // The largest value over the whole range is at the critical speed, below the operating range.
  const double zeta = 0.02,
               scaled_m = 25.4e-6 / amplification(50 / 30.0, 0.02) / (2 * zeta * std::sqrt(1 - zeta * zeta));
  EXPECT_NEAR(check.clearances.at(0).major_axis_m, scaled_m, 1e-9 * scaled_m);
  EXPECT_NEAR(check.clearances.at(0).margin, 1 - scaled_m / (0.75 * 2e-3), 1e-9);
  ASSERT_EQ(check.locks.size(), 3u);
  const double damped_hz = 30 * std::sqrt(1 - zeta * zeta);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(check.locks[k].speed_hz / damped_hz, (std::vector{2.0, 3.0, 5.0})[k], 1e-9);
  EXPECT_TRUE(check.whips.empty()) << "no annular stop";
  EXPECT_EQ(check.no_kicks, "not asked for");
}

TEST(DesignCheck, LocksAreThoseOfTheOperatingRange) {
  const DesignCheck check = checked(study_of(scene::one_side_machine()), {{70, 100}, {}, 0, 1});
  ASSERT_EQ(check.locks.size(), 1u);
  EXPECT_EQ(check.locks[0].p, 2);
}

TEST(DesignCheck, KicksAreTriedAtEvenSpeedsAndAtLockSpeeds) {
  const DesignCheck check = checked(study_of(scene::one_side_machine()), {{70, 100}, 5e-5, 2, 1});
  EXPECT_EQ(check.eccentricity_m, 5e-5);
  ASSERT_EQ(check.kicks.size(), 3u);
  EXPECT_EQ(check.kicks[0].speed_hz, 70);
  EXPECT_EQ(check.kicks[1].speed_hz, check.locks[0].speed_hz);
  EXPECT_EQ(check.kicks[2].speed_hz, 100);
  model::Machine machine = scene::one_side_machine();
  machine.kick.reset();
  EXPECT_EQ(checked(study_of(machine), {{70, 100}, {}, 2, 1}).no_kicks, "the configuration has no kick");
}

TEST(DesignCheck, MarginOfDryWhip) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].geometry = model::AnnularGeometry{};
  machine.stops[0].casing.reset();
  machine.stops[0].friction = model::ConstantFriction{0.01};
  const double b = 2e6 / (0.8 * std::pow(2 * std::numbers::pi * 30, 2));
  const double least = 2 * 0.02 * std::sqrt(1 + b) / b;
  const DesignCheck check = checked(study_of(machine), {{50, 160}, {}, 0, 1});
  EXPECT_NEAR(check.whips.at(0).margin(), 1 - 0.01 / least, 1e-9);
  EXPECT_EQ(WhipMargin({0, 0.3, {}}).margin(), 1);
  EXPECT_EQ(WhipMargin({0, 0, DryWhip{}}).margin(), 1);
}

TEST(DesignCheck, BeginsWhereTablesBegin) {
  const model::Machine machine = scene::table_machine();
  EXPECT_EQ(whole_range(machine, {50, 110}).from_hz, 20);
  EXPECT_NEAR(whole_range(scene::one_side_machine(), {50, 110}).from_hz, 0.11, 1e-15);
  const DesignCheck check = checked(study_of(machine), {{50, 110}, {}, 0, 1});
  EXPECT_GT(check.clearances.at(0).speed_hz, 20);
  EXPECT_THROW(checked(study_of(machine), {{50, 130}, {}, 0, 1}), ConfigError);
}

const std::vector<double> to_120_hz = batch::evenly_spaced(0.5, 120, 240);

/// A whirl whose diameter at resonance is 90 % of the limit. Using a radius for either diameter would give a
/// margin of 0.55 or -0.8.
TEST(DesignCheck, ComparesADiameterWithADiameter) {
  model::Machine machine = scene::one_side_machine();
  const double zeta = 0.02, largest = 1 / (2 * zeta * std::sqrt(1 - zeta * zeta));
  const double eccentricity_m = 0.9 * 0.75 * machine.stops[0].clearance_m / largest;
  const auto margins = clearance_margins(scene::prepare_machine(machine), eccentricity_m, to_120_hz);
  ASSERT_EQ(margins.size(), 1u);
  EXPECT_NEAR(margins[0].margin, 0.1, 1e-9);
  EXPECT_NEAR(margins[0].diametral_clearance_m, 2e-3, 1e-15);
  EXPECT_NEAR(margins[0].major_axis_m, 0.9 * 0.75 * 2e-3, 1e-12);
  EXPECT_NEAR(margins[0].speed_hz, 30 / std::sqrt(1 - 2 * zeta * zeta), 1e-4);
}

TEST(DesignCheck, OffsetAndWeightTakeFromTheClearance) {
  model::Machine machine = scene::one_side_machine();
  machine.stops[0].geometry = model::AnnularGeometry{{3e-4, 4e-4}};
  EXPECT_NEAR(clearance_margins(scene::prepare_machine(machine), 1e-6, to_120_hz)[0].diametral_clearance_m,
              1e-3, 1e-12);
  machine.stops[0].geometry = model::OneSideGeometry{-90};
  machine.stops[0].casing.reset();
  machine.gravity_m_per_s2 = 9.81;
  const double sag_m = 9.81 / std::pow(2 * std::numbers::pi * 30, 2);
  EXPECT_NEAR(clearance_margins(scene::prepare_machine(machine), 1e-6, to_120_hz)[0].diametral_clearance_m,
              2 * (1e-3 - sag_m), 1e-9);
  machine.gravity_m_per_s2 = 99;
  const ClearanceMargin pressed = clearance_margins(scene::prepare_machine(machine), 1e-6, to_120_hz)[0];
  EXPECT_EQ(pressed.diametral_clearance_m, 0);
  EXPECT_TRUE(std::isinf(pressed.margin) && pressed.margin < 0);
}

/// Two discs on unequal supports: the left stop is critical in the first mode, the right one in the second.
model::Machine two_stops() {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.discs[0].position_m = 0.05;
  kit.discs.push_back(kit.discs[0]);
  kit.discs[1].position_m = 0.35;
  kit.supports[0].stiffness_x_n_per_m = kit.supports[0].stiffness_y_n_per_m = 2e4;
  kit.supports[1].stiffness_x_n_per_m = kit.supports[1].stiffness_y_n_per_m = 2e5;
  kit.shaft[0].outer_diameter_m = 0.03;
  kit.modes = 4;
  machine.stops.front().position_m = 0.05;
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().position_m = 0.35;
  return machine;
}

/// Amplitudes of the whole rotor at a stop for an eccentricity of 1 m.
Eigen::Vector2cd at_stop(const WholeRotor& rotor, const model::Stop& stop, double speed_hz) {
  const Eigen::Index place = rotor.place(stop.position_m);
  const Eigen::VectorXcd q = rotor.response(rotor.configured_kg(), speed_hz);
  return {(rotor.rotor().x.row(place) * q).value(), (rotor.rotor().y.row(place) * q).value()};
}

TEST(DesignCheck, EachStopIsLookedAtAtItsOwnSpeed) {
  const scene::PreparedMachine prepared = scene::prepare_machine(two_stops());
  const double eccentricity_m = 1e-5;
  const auto margins = clearance_margins(prepared, eccentricity_m, to_120_hz);
  ASSERT_EQ(margins.size(), 2u);
  const WholeRotor rotor(prepared.machine);
  const auto margin_at = [&](std::size_t stop, double hz) {
    return 1 - eccentricity_m * major_axis(at_stop(rotor, prepared.machine.stops[stop], hz)) / (0.75 * 2e-3);
  };
  for (std::size_t stop = 0; stop < 2; ++stop) {
    double smallest = 1;
    for (const double hz : batch::evenly_spaced(0.5, 120, 60001))
      smallest = std::min(smallest, margin_at(stop, hz));
    EXPECT_NEAR(margins[stop].margin, smallest, 1e-6) << stop;
  }
  EXPECT_GT(margins[1].speed_hz, 1.5 * margins[0].speed_hz);
  EXPECT_GT(margin_at(1, margins[0].speed_hz), margins[1].margin + 0.02) << "one speed for both hides it";
}

/// A bearing with cross stiffness inclines the orbit: its extent along x is shorter than its major axis.
TEST(DesignCheck, TakesTheMajorAxisAndNotTheMotionAlongX) {
  model::Machine machine = scene::light_shaft_machine();
  for (model::Support& support : model::kit_of(machine)->supports)
    support.stiffness_xy_n_per_m = support.stiffness_yx_n_per_m = 1.2e4;
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  const ClearanceMargin found = clearance_margins(prepared, 1e-6, to_120_hz)[0];
  const Eigen::Vector2cd there = at_stop(WholeRotor(machine), machine.stops[0], found.speed_hz);
  double farthest_m = 0;
  for (int k = 0; k < 3600; ++k) {
    const std::complex<double> turned = std::polar(1.0, 2 * std::numbers::pi * k / 3600);
    farthest_m = std::max(farthest_m, std::hypot((there(0) * turned).real(), (there(1) * turned).real()));
  }
  EXPECT_NEAR(found.major_axis_m, 2 * 1e-6 * farthest_m, 1e-5 * found.major_axis_m);
  EXPECT_GT(found.major_axis_m, 1.25 * 2 * 1e-6 * std::abs(there(0)));
}

/// Modes that a kit leaves out for its cells do not change what is checked.
TEST(DesignCheck, IsOfTheWholeRotorAndNotOfItsModes) {
  model::Machine machine = two_stops();
  const auto margins = [&](int modes) {
    model::kit_of(machine)->modes = modes;
    return clearance_margins(scene::prepare_machine(machine), 1e-5, to_120_hz);
  };
  const std::vector<ClearanceMargin> few = margins(1), many = margins(8);
  for (std::size_t stop = 0; stop < 2; ++stop) {
    EXPECT_NEAR(few[stop].major_axis_m, many[stop].major_axis_m, 1e-9 * many[stop].major_axis_m) << stop;
    EXPECT_NEAR(few[stop].margin, many[stop].margin, 1e-9) << stop;
  }
}

TEST(DesignCheck, IsOneMilUpToTwelveThousandRevolutionsAMinute) {
  EXPECT_DOUBLE_EQ(vibration_limit_m(3000 / 60.0), 25.4e-6);
  EXPECT_DOUBLE_EQ(vibration_limit_m(12000 / 60.0), 25.4e-6);
}

/// At four times the speed the limit is one half; without the root in 12000 / N it would be a quarter.
TEST(DesignCheck, FallsWithTheRootOfTheSpeedBeyond) {
  EXPECT_DOUBLE_EQ(vibration_limit_m(48000 / 60.0), 12.7e-6);
  EXPECT_NEAR(vibration_limit_m(24000 / 60.0), 17.9605e-6, 1e-10);
}

TEST(DesignCheck, EccentricityOfTheAnalysisOfAJeffcottRotorDependsOnTheSpeedAlone) {
  // Unbalance 4 x 6350 W / N in g mm, for a rotor of W kg.
  EXPECT_NEAR(analysis_eccentricity_m(scene::one_side_machine(), 12000 / 60.0), 4 * 6350.0 / 12000 * 1e-6,
              1e-15);
}

TEST(DesignCheck, EccentricityOfTheAnalysisOfAKitIsForTheMassOfTheWholeRotor) {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.discs[0].eccentricity_ratio = 0.5;
  EXPECT_NEAR(analysis_eccentricity_m(machine, 100), 2 * 4 * 6350.0 / 6000 * 1e-6, 1e-12);
  kit.discs[0].eccentricity_ratio = 0;
  EXPECT_THROW(analysis_eccentricity_m(machine, 100), ConfigError);
}

TEST(DesignCheck, ScaleFactorBringsTheResponseToTheLimitFromHalfToSixfold) {
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 10e-6), 2.5);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 40e-6), 0.625);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 60e-6), 0.5);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 1e-6), 6);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 0), 6);
}

}  // namespace
}  // namespace rubsweep::design
