#include <gtest/gtest.h>

#include <numbers>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "scene/kit_machine.hpp"

namespace rubsweep::sweep {
namespace {

/// A heavy disc on a 10 mm shaft that rubs beside it; damped enough to settle soon.
Study kit_study(double speed_hz, double whirl_ratio) {
  Study study;
  study.machine = scene::light_shaft_machine();
  model::RotorKit& kit = *study.machine.kit;
  kit.shaft[0].density_kg_per_m3 = 7850;
  kit.damping_ratio = {0.06};
  kit.modes_up_to_hz = 600;
  kit.modes.reset();
  kit.elements = 8;
  study.machine.stops[0].position_m = 0.26;
  study.machine.kick->position_m = 0.2;
  study.grid.speed_hz = {speed_hz};
  study.grid.unbalance = {whirl_ratio};
  study.solver.relative_tolerance = 1e-7;
  study.response = {
      .max_revolutions = 90, .samples_per_revolution = 32, .window_revolutions = 12, .max_order = 6};
  return study;
}

int modes_of(const Study& study) {
  return static_cast<int>(scene::make_plan(study.machine).reduction->mode_number[0].size());
}

/// Observed displacement after `turns` revolutions.
Eigen::Vector2d section_after(const Study& study, int turns) {
  const scene::Cell cell =
      scene::build_cell(study.machine, study.grid.speed_hz[0], scene::WhirlRatio{study.grid.unbalance[0]});
  const integrate::Cursor cursor = integrate::start_adaptive(cell.scene, study.solver);
  integrate::Turn turn;
  for (int i = 0; i < turns; ++i) EXPECT_EQ(cursor(turn), integrate::Outcome::ok);
  const auto& map = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  return map * Eigen::Map<const Eigen::VectorXd>(turn.section.data(), cell.scene.structure.coordinates());
}

TEST(KitModes, MoreModesChangeNeitherLabelNorSection) {
  Study study = kit_study(70, 0.7);
  response::Workspace workspace;
  const Row automatic = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(automatic.motion_class, response::MotionClass::subharmonic);
  EXPECT_EQ(automatic.order, 2);
  const Eigen::Vector2d section = section_after(study, 80);
  study.machine.kit->modes = modes_of(study) + 2;
  const Row more = evaluate_cell(study, 0, workspace);
  EXPECT_EQ(more.motion_class, automatic.motion_class);
  EXPECT_EQ(more.order, automatic.order);
  EXPECT_NEAR(more.measures->contact.peak_displacement_m, automatic.measures->contact.peak_displacement_m, 0.01 * automatic.measures->contact.peak_displacement_m);
  EXPECT_LT((section_after(study, 80) - section).norm(), 0.02 * section.norm());
}

TEST(KitModes, ProvenRestIsRest) {
  const Study study = kit_study(70, 0.1);
  response::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  ASSERT_EQ(row.proof, response::Proof::rest);
  ASSERT_TRUE(row.last_contact_revolution);
  const scene::Cell cell = scene::build_cell(study.machine, 70, scene::WhirlRatio{0.1});
  const integrate::Cursor cursor = integrate::start_adaptive(cell.scene, study.solver);
  integrate::Turn turn;
  for (long i = 1; i <= row.revolutions + 60; ++i) {
    ASSERT_EQ(cursor(turn), integrate::Outcome::ok);
    EXPECT_TRUE(i <= *row.last_contact_revolution || !turn.touched) << i;
  }
}

}  // namespace
}  // namespace rubsweep::sweep
