#include "rubsweep/design/design_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "design/amplification.hpp"
#include "design/study_of.hpp"
#include "rubsweep/error.hpp"
#include "scene/table_machine.hpp"

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
  // Over the whole range: at the critical speed below the operating range.
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

}  // namespace
}  // namespace rubsweep::design
