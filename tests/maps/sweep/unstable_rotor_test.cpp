#include "rubsweep/maps/sweep/unstable_rotor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/report/explain_study.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

std::string where(const Study& study) {
  return where_rotor_is_unstable(study, scene::prepare_machine(study.machine));
}

/// A shaft that hardly bends in two equal bearings bounces as one mass: m z'' + 2 c z' + (2 k - 2 i q) z = 0
/// has a forward whirl that grows where q > c sqrt(2 k / m).
Study bouncing_shaft(double cross_n_per_m) {
  Study study = one_side_study({20, 50}, {0.3});
  model::RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = 0.06,
                 .youngs_modulus_pa = 2.06e14,
                 .shear_modulus_pa = 7.92e13,
                 .density_kg_per_m3 = 7850},
                0.4}};
  kit.discs = {
      {.position_m = 0.2, .mass_kg = 1, .polar_inertia_kg_m2 = 1e-3, .diametral_inertia_kg_m2 = 6e-4}};
  for (const double position_m : {0.0, 0.4}) {
    model::Support& support = kit.supports.emplace_back();
    support.position_m = position_m;
    support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 1e6;
    support.damping_x_ns_per_m = support.damping_y_ns_per_m = 200;
    support.stiffness_xy_n_per_m = cross_n_per_m;
    support.stiffness_yx_n_per_m = -cross_n_per_m;
  }
  kit.modes = 2;
  study.machine.rotor = kit;
  study.machine.kick.reset();
  study.machine.stops.front().position_m = 0.2;
  return study;
}

double limit_n_per_m() {
  const double mass_kg = 1 + 7850 * std::acos(-1.0) * 0.03 * 0.03 * 0.4;
  return 200 * std::sqrt(2e6 / mass_kg);
}

TEST(UnstableRotor, CrossCoupledBearingsAreNamedFromTheirLimitOn) {
  EXPECT_EQ(where(bouncing_shaft(0.98 * limit_n_per_m())), "");
  const Study study = bouncing_shaft(1.02 * limit_n_per_m());
  EXPECT_TRUE(where(study).starts_with("unstable rotor: at 2 of 2 speeds looked at, from 20 to 50 Hz"))
      << where(study);
  EXPECT_NE(report::explain_study(study).find(where(study)), std::string::npos);
}

/// A reduced rotor without its seal, which feeds a bending by the full matrices.
TEST(UnstableRotor, AReductionThatTheFullMatricesContradictIsNoBasisOfAWord) {
  Study study = bouncing_shaft(0);
  model::RotorKit& kit = *model::kit_of(study.machine);
  kit.shaft.front().outer_diameter_m = 0.012;
  kit.shaft.front().youngs_modulus_pa = 2.06e11, kit.shaft.front().shear_modulus_pa = 7.92e10;
  model::Support& seal = kit.supports.emplace_back(kit.supports.front());
  seal.position_m = 0.1;
  seal.stiffness_x_n_per_m = seal.stiffness_y_n_per_m = 0;
  seal.damping_x_ns_per_m = seal.damping_y_ns_per_m = 0;
  kit.modes.reset();
  const auto with_seal = [&](double cross_n_per_m) {
    seal.stiffness_xy_n_per_m = cross_n_per_m, seal.stiffness_yx_n_per_m = -cross_n_per_m;
    return scene::prepare_machine(study.machine);
  };
  const scene::PreparedMachine stable = with_seal(0), unstable = with_seal(1e6);
  EXPECT_EQ(where_rotor_is_unstable(study, stable), "");
  EXPECT_NE(where_rotor_is_unstable(study, unstable), "");
  scene::PreparedMachine mistaken = stable;
  mistaken.machine = unstable.machine;
  EXPECT_THROW(where_rotor_is_unstable(study, mistaken), ConfigError);
}

TEST(UnstableRotor, EveryRowSaysSoWhateverItsClassAndStart) {
  response::motion::Workspace workspace;
  Study study = bouncing_shaft(1.05 * limit_n_per_m());
  study.grid.unbalance = {0.3, 1.5};
  for (std::size_t cell = 0; cell < cell_count(study.grid); ++cell) {
    const Row row = evaluate_cell(study, cell, workspace);
    EXPECT_NE(row.status.find(unstable_rotor), std::string::npos) << cell << ": " << row.status;
    EXPECT_NE(row.motion_class, response::motion::MotionClass::non_contact) << cell;
  }
  study = bouncing_shaft(0.5 * limit_n_per_m());
  EXPECT_EQ(evaluate_cell(study, 0, workspace).status.find(unstable_rotor), std::string::npos);
}

/// Films by a table that push sideways more and more with the speed pass the limit between two speeds.
TEST(UnstableRotor, FollowsTheTableOfASupport) {
  Study study = bouncing_shaft(0);
  const double limit = limit_n_per_m();
  model::SupportTable table;
  table.speed_hz = {10, 30, 40, 60};
  table.columns.fill(std::vector<double>(4, 0));
  table.columns[0] = table.columns[3] = std::vector<double>(4, 1e6);
  table.columns[1] = {0.5 * limit, 0.9 * limit, 1.1 * limit, 1.5 * limit};
  table.columns[2] = {-0.5 * limit, -0.9 * limit, -1.1 * limit, -1.5 * limit};
  table.columns[4] = table.columns[7] = std::vector<double>(4, 200);
  for (model::Support& support : model::kit_of(study.machine)->supports)
    support = model::with_table(support, table);
  study.grid.speed_hz = {20, 30, 40, 50};
  EXPECT_TRUE(where(study).starts_with("unstable rotor: at 2 of 4 speeds looked at, from 40 to 50 Hz"))
      << where(study);
  EXPECT_NE(report::explain_study(study).find(where(study)), std::string::npos);
  response::motion::Workspace workspace;
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const bool said = evaluate_cell(study, cell, workspace).status.find(unstable_rotor) != std::string::npos;
    EXPECT_EQ(said, cell >= 2) << cell;
  }
}

/// 30 Hz, 0.02 against 0.05: unstable from 42 Hz on.
TEST(UnstableRotor, OnlyTheSpeedsAboveTheLimitOfDampingThatTurns) {
  Study study = one_side_study({30, 41, 43, 60}, {0.3});
  auto& rotor = std::get<model::JeffcottRotor>(study.machine.rotor);
  rotor.natural_frequency_hz = 30;
  rotor.damping_ratio = 0.02;
  rotor.rotating_damping_ratio = 0.05;
  EXPECT_TRUE(where(study).starts_with("unstable rotor: at 2 of 4 speeds looked at, from 43 to 60 Hz"))
      << where(study);
  response::motion::Workspace workspace;
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const bool said = evaluate_cell(study, cell, workspace).status.find(unstable_rotor) != std::string::npos;
    EXPECT_EQ(said, cell >= 2) << cell;
  }
}

TEST(UnstableRotor, RoundingIsNoGrowth) {
  Study study = one_side_study({30, 60}, {0.3});
  std::get<model::JeffcottRotor>(study.machine.rotor).damping_ratio = 0;
  EXPECT_EQ(where(study), "");
  study = bouncing_shaft(0);
  for (model::Support& support : std::get<model::RotorKit>(study.machine.rotor).supports)
    support.damping_x_ns_per_m = support.damping_y_ns_per_m = 0;
  EXPECT_EQ(where(study), "");
  response::motion::Workspace workspace;
  EXPECT_EQ(evaluate_cell(study, 1, workspace).status.find(unstable_rotor), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::sweep
