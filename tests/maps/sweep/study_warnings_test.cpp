#include "rubsweep/maps/sweep/study_warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <variant>

#include "core/scene/kit_machine.hpp"
#include "explain/explain_study.hpp"
#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

std::string why(const Study& study) {
  return why_walls_stay_untouched(study, scene::prepare_machine(study.machine));
}

TEST(StudyWarningsUntouchedWalls, AKickThatReachesTheWallIsNoReason) {
  EXPECT_EQ(why(one_side_study({60, 75}, {0.2, 0.4})), "");
}

TEST(StudyWarningsUntouchedWalls, WithoutAKickNothingTouches) {
  Study study = one_side_study({60, 75}, {0.2, 0.4});
  study.machine.kick.reset();
  EXPECT_TRUE(why(study).starts_with("no kick: "));
  EXPECT_NE(apps::explain_study(study).find(why(study)), std::string::npos);
  // With a given start there is no warning, not even about a missing kick.
  study.machine.start = {.rotor = {.y_m = 1e-5}};
  EXPECT_EQ(why(study), "");
  study.machine.start.reset();
  // For whirl ratios above 1 no kick is needed.
  study.grid.unbalance = {1.2};
  EXPECT_EQ(why(study), "");
}

TEST(StudyWarningsUntouchedWalls, AWeakKickIsNamedAndReallyTouchesNothing) {
  Study study = one_side_study({60, 75}, {0.4, 1.2, 0.1});
  study.machine.kick->force_n = 20;
  EXPECT_TRUE(why(study).starts_with("weak kick: 20 N for 0.005 s reach no wall"));
  response::motion::Workspace workspace;
  for (const std::size_t cell : {0U, 1U, 4U, 5U}) {
    EXPECT_FALSE(evaluate_cell(study, cell, workspace).last_contact_revolution) << cell;
  }
  // One cell close enough to the wall, or one such speed, suppresses the warning.
  study.grid.unbalance = {0.1, 0.999};
  EXPECT_EQ(why(study), "");
}

/// An impulse m v moves a Jeffcott rotor by v / w at most, so 2 F T / (pi m w) equals the clearance left by
/// the whirl.
TEST(StudyWarningsUntouchedWalls, TheLeastForceIsThatOfTheImpulse) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick->force_n = 2;
  const auto& rotor = std::get<model::JeffcottRotor>(study.machine.rotor);
  const double w = 2 * std::numbers::pi * rotor.natural_frequency_hz, m = rotor.mass_kg;
  const double left_m = 0.6 * study.machine.stops.front().clearance_m;
  const double impulse_force_n = left_m * std::numbers::pi * m * w / (2 * study.machine.kick->duration_s);
  const auto least = least_kick_force_n(study, scene::prepare_machine(study.machine));
  ASSERT_TRUE(least);
  // The whirl also adds to the velocity, and damping reduces it slightly: the results agree within a third.
  EXPECT_GT(*least, impulse_force_n / 1.5);
  EXPECT_LT(*least, impulse_force_n * 1.1);
  study.machine.kick->force_n = *least;
  EXPECT_EQ(why(study), "");
  study.machine.kick->force_n = *least / 1.02;
  EXPECT_NE(why(study), "");
  // There is no question if the kick is strong enough or absent.
  study.machine.kick->force_n = 1000;
  EXPECT_FALSE(least_kick_force_n(study, scene::prepare_machine(study.machine)));
  study.machine.kick->force_n = 0;
  EXPECT_FALSE(least_kick_force_n(study, scene::prepare_machine(study.machine)));
}

TEST(StudyWarningsUntouchedWalls, FaultyBearingsMayMoveTheRotorAllTheSame) {
  Study study = one_side_study({75}, {0.4});
  study.machine.kick.reset();
  study.machine.stops.front().clearance_m = 1e-3;
  scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  prepared.assembly.impulses.push_back(
      {Eigen::VectorXd::Unit(prepared.assembly.system.coordinates(), 1), 1, 0});
  EXPECT_EQ(why_walls_stay_untouched(study, prepared), "");
}

model::Machine twisting(const model::Friction& friction) {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.torsion = model::Torsion{.drive_stiffness_nm_per_rad = 20, .drive_damping_nms_per_rad = 0.01};
  kit.damping_ratio = {0.06};
  machine.stops[0].friction = friction;
  return machine;
}

std::string why(const model::Friction& friction, double speed_hz = 50) {
  return why_torsion_is_idle(scene::prepare_machine(twisting(friction)), speed_hz);
}

TEST(StudyWarningsIdleTorsionWhyIs, SaysSoWhereNoFrictionAsksForTheSlip) {
  EXPECT_NE(why(model::NoFriction{}), "");
  EXPECT_NE(why(model::OneWayFriction{0.005}), "");
  EXPECT_NE(why(model::StribeckFriction{{0, 0, 0, 0.005, 100, 0}}), "");
  EXPECT_EQ(why(model::OneWayFriction{0.1}), "") << "hits that turn the unbalance by two degrees";
  EXPECT_EQ(why(model::StribeckFriction{{0, 0, 0, 0.005, 100, 0.01}}), "") << "viscous";
  EXPECT_EQ(why(model::StribeckFriction{{0, 0, 0, 0.005, 100, 0}}, 0.1), "") << "a shaft that hardly turns";
  EXPECT_EQ(why_torsion_is_idle(scene::prepare_machine(scene::light_shaft_machine()), 50), "")
      << "no torsion";
  model::Machine started = twisting(model::NoFriction{});
  started.kick.reset();
  started.start.emplace();
  EXPECT_EQ(why_torsion_is_idle(scene::prepare_machine(started), 50), "") << "hits of any strength";
}

TEST(StudyWarningsIdleTorsionWhyIs, AsksEveryStop) {
  // For the smaller of two radii the slip changes less in absolute and more in relative terms.
  model::Machine machine = twisting(model::OneWayFriction{0.005});
  machine.stops.push_back(machine.stops[0]);
  machine.stops[1].contact_radius_m *= 0.4;
  machine.stops[1].friction = model::OneWayFriction{0.025};
  ASSERT_NE(why_torsion_is_idle(scene::prepare_machine(machine), 50), "");
  machine.stops[1].friction = model::OneWayFriction{0.1};
  EXPECT_EQ(why_torsion_is_idle(scene::prepare_machine(machine), 50), "");
}

/// The warning is true: the row is nearly that of the rotor without torsion.
TEST(StudyWarningsIdleTorsionWhyIs, TheMotionIsTheSameWithoutTorsion) {
  ASSERT_NE(why(model::StribeckFriction{{0, 0, 0, 0.005, 100, 0}}, 60), "");
  Study study;
  study.machine = twisting(model::StribeckFriction{{0, 0, 0, 0.005, 100, 0}});
  study.grid.speed_hz = {60};
  study.grid.unbalance = {0.6};
  study.response = {
      .max_revolutions = 60, .samples_per_revolution = 32, .window_revolutions = 12, .max_order = 6};
  response::motion::Workspace workspace;
  const Row with = evaluate_cell(study, 0, workspace);
  model::kit_of(study.machine)->torsion.reset();
  const Row without = evaluate_cell(study, 0, workspace);
  ASSERT_TRUE(with.measures && without.measures);
  EXPECT_TRUE(with.last_contact_revolution);
  EXPECT_EQ(to_string(with.motion_class), to_string(without.motion_class));
  EXPECT_NEAR(with.measures->contact.peak_displacement_m, without.measures->contact.peak_displacement_m,
              1e-2 * without.measures->contact.peak_displacement_m);
}

std::string where(const Study& study) {
  return where_rotor_is_unstable(study, scene::prepare_machine(study.machine));
}

/// A nearly rigid shaft in two equal bearings bounces as one mass: m z'' + 2 c z' + (2 k - 2 i q) z = 0. Its
/// forward whirl grows where q > c sqrt(2 k / m).
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

TEST(StudyWarningsUnstableRotor, CrossCoupledBearingsAreNamedFromTheirLimitOn) {
  EXPECT_EQ(where(bouncing_shaft(0.98 * limit_n_per_m())), "");
  const Study study = bouncing_shaft(1.02 * limit_n_per_m());
  EXPECT_TRUE(where(study).starts_with("unstable rotor: at 2 of 2 speeds looked at, from 20 to 50 Hz"))
      << where(study);
  EXPECT_NE(apps::explain_study(study).find(where(study)), std::string::npos);
}

/// A reduced rotor without its seal, which destabilises a bending mode according to the full matrices.
TEST(StudyWarningsUnstableRotor, AReductionThatTheFullMatricesContradictIsNoBasisOfAWord) {
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

TEST(StudyWarningsUnstableRotor, EveryRowSaysSoWhateverItsClassAndStart) {
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

/// Films given by a table, whose cross stiffness rises with the speed and passes the stability limit between
/// two speeds.
TEST(StudyWarningsUnstableRotor, FollowsTheTableOfASupport) {
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
  EXPECT_NE(apps::explain_study(study).find(where(study)), std::string::npos);
  response::motion::Workspace workspace;
  for (std::size_t cell = 0; cell < 4; ++cell) {
    const bool said = evaluate_cell(study, cell, workspace).status.find(unstable_rotor) != std::string::npos;
    EXPECT_EQ(said, cell >= 2) << cell;
  }
}

/// 30 Hz, damping ratio 0.02, rotating damping ratio 0.05: unstable above 42 Hz.
TEST(StudyWarningsUnstableRotor, OnlyTheSpeedsAboveTheLimitOfDampingThatTurns) {
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

TEST(StudyWarningsUnstableRotor, RoundingIsNoGrowth) {
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
