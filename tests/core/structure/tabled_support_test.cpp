#include "rubsweep/core/structure/tabled_support.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/scene/table_machine.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::structure {
namespace {

TEST(TabledSupportAt, IsTheRowOfTheTableAtItsSpeeds) {
  const model::Machine machine = machine_at(scene::table_machine(), 55), typed = scene::typed_machine(2);
  for (std::size_t i = 0; i < 2; ++i) {
    const model::Support &found = model::kit_of(machine)->supports[i],
                         &expected = model::kit_of(typed)->supports[i];
    EXPECT_FALSE(found.table);
    EXPECT_EQ(found.stiffness_x_n_per_m, expected.stiffness_x_n_per_m);
    EXPECT_EQ(found.stiffness_yx_n_per_m, expected.stiffness_yx_n_per_m);
    EXPECT_EQ(found.damping_xy_ns_per_m, expected.damping_xy_ns_per_m);
    EXPECT_EQ(found.damping_y_ns_per_m, expected.damping_y_ns_per_m);
  }
}

TEST(TabledSupportAt, RefusesSpeedsBeyondTheTable) {
  const model::Machine machine = scene::table_machine();
  for (const double speed_hz : {19.9, 120.5})
    EXPECT_NE(message_of<ConfigError>([&] {
                machine_at(machine, speed_hz);
              }).find(" rpm), allowed: speeds from 20 to 120 Hz (1200 to 7200 rpm)"),
              std::string::npos);
  EXPECT_NE(message_of<ConfigError>([&] {
              refuse_beyond_tables(machine, 20, 121);
            }).find("rotor.supports.0.table: does not reach 121 Hz (7260 rpm)"),
            std::string::npos);
  EXPECT_NO_THROW(refuse_beyond_tables(machine, 20, 120));
}

TEST(TabledSupport, LacksNothingAtTheSpeedThatIsBuiltIn) {
  model::Support support;
  support.position_m = 0;
  support = model::with_table(support, scene::film_table());
  const TabledSupport tabled = tabled_support(support);
  const SupportMatrices none = tabled.lacking(2 * std::numbers::pi * 55);
  EXPECT_LT(none.stiffness.norm(), 1e-9);
  EXPECT_LT(none.damping.norm(), 1e-12);
  const SupportMatrices some = tabled.lacking(2 * std::numbers::pi * 120);
  EXPECT_NEAR(some.stiffness(0, 1), 2000 - 1100, 1e-9);
  EXPECT_NEAR(some.damping(1, 1), 45 - 65, 1e-12);
}

/// In a shaft with all its coordinates a support depends on a few of them; in reduced coordinates it depends
/// on all.
TEST(TabledSupport, AddsTheSameToFewCoordinatesAsToAll) {
  model::Support support;
  support.position_m = 0;
  TabledSupport tabled = tabled_support(model::with_table(support, scene::film_table()));
  const double w = 2 * std::numbers::pi * 120;
  for (const bool few : {true, false}) {
    tabled.map = Eigen::MatrixXd::Constant(2, 8, few ? 0.0 : 0.3);
    tabled.map(0, 1) = 1, tabled.map(1, 4) = -2;
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(8, 8), damping = mass, stiffness = mass;
    add_lacking(tabled, w, mass, damping, stiffness);
    const SupportMatrices lacking = tabled.lacking(w);
    for (Eigen::Index i = 0; i < 8; ++i) {
      for (Eigen::Index k = 0; k < 8; ++k) {
        double force = 0, by_rate = 0;
        for (Eigen::Index a = 0; a < 2; ++a) {
          for (Eigen::Index b = 0; b < 2; ++b) {
            force += tabled.map(a, i) * lacking.stiffness(a, b) * tabled.map(b, k);
            by_rate += tabled.map(a, i) * lacking.damping(a, b) * tabled.map(b, k);
          }
        }
        EXPECT_NEAR(stiffness(i, k), force, 1e-9);
        EXPECT_NEAR(damping(i, k), by_rate, 1e-9);
      }
    }
  }
}

TEST(TabledSupportRefuseChangingMass, LetsAMassThatStaysTheSamePass) {
  model::Machine machine = scene::table_machine();
  model::SupportTable& table = *model::kit_of(machine)->supports[1].table;
  table.columns[8].assign(5, 0.3);
  EXPECT_NO_THROW(refuse_changing_mass(machine, "a run-up"));
  table.columns[8].back() = 0.4;
  EXPECT_NE(message_of<ConfigError>([&] {
              refuse_changing_mass(machine, "a run-up");
            }).find("rotor.supports.1.table: a run-up cannot follow a mass"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::structure
