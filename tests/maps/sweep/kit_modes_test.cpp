#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

/// A 10 mm shaft with a heavy disc that rubs beside it; strongly damped, so that it settles quickly.
Study kit_study(double speed_hz, double whirl_ratio) {
  Study study;
  study.machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(study.machine);
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
  return static_cast<int>(scene::prepare_machine(study.machine).reduction->mode_number[0].size());
}

/// Displacement of the observed point after the 1/2 motion has settled, at its section.
Eigen::Vector2d settled_section(const Study& study) {
  const scene::Cell cell =
      scene::build_cell(study.machine, study.grid.speed_hz[0], scene::WhirlRatio{study.grid.unbalance[0]});
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(cell.scene, study.solver, modes);
  integrate::run::TurnReport turn;
  for (int i = 0; i < 80; ++i) EXPECT_EQ(run.advance({}, turn), integrate::run::Outcome::ok);
  const auto& map = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  return map * Eigen::Map<const Eigen::VectorXd>(turn.section.data(), cell.scene.structure.coordinates());
}

TEST(KitModes, SectionsConvergeWithTheNumberOfModes) {
  Study study = kit_study(70, 0.7);
  const int automatic = modes_of(study);
  const auto section = [&](int modes) {
    model::kit_of(study.machine)->modes = modes;
    return settled_section(study);
  };
  const Eigen::Vector2d reference = section(automatic + 5);
  std::vector<double> errors;
  for (const int modes : {1, automatic, automatic + 2})
    errors.push_back((section(modes) - reference).norm() / reference.norm());
  EXPECT_GT(errors[0], 0.1);
  EXPECT_LT(errors[1], 1e-4);
  EXPECT_LT(errors[2], errors[1] / 2);
}

/// A map of two tongues and the region below their tips.
TEST(KitModes, MoreModesChangeNoLabelOfAMap) {
  Study study = kit_study(70, 0.7);
  study.grid.speed_hz = {66, 100};
  study.grid.unbalance = {0.5, 0.8};
  Study more = study;
  model::kit_of(more.machine)->modes = modes_of(study) + 3;
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine),
                               finer = scene::prepare_machine(more.machine);
  response::motion::Workspace workspace;
  std::set<std::pair<response::motion::MotionClass, int>> labels;
  for (std::size_t i = 0; i < cell_count(study.grid); ++i) {
    const Row a = evaluate_cell(study, prepared, i, workspace), b = evaluate_cell(more, finer, i, workspace);
    EXPECT_EQ(a.motion_class, b.motion_class) << a.speed_hz;
    EXPECT_EQ(a.order, b.order) << a.speed_hz;
    EXPECT_NEAR(
        a.measures.value().contact.peak_displacement_m / b.measures.value().contact.peak_displacement_m, 1,
        1e-4);
    labels.emplace(a.motion_class, a.order.value_or(0));
  }
  using enum response::motion::MotionClass;
  EXPECT_EQ(labels, (decltype(labels){{non_contact, 0}, {subharmonic, 2}, {subharmonic, 3}}));
}

TEST(KitModes, ProvenRestIsRest) {
  const Study study = kit_study(70, 0.1);
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  ASSERT_EQ(row.proof, response::motion::Proof::rest);
  ASSERT_TRUE(row.last_contact_revolution);
  const scene::Cell cell = scene::build_cell(study.machine, 70, scene::WhirlRatio{0.1});
  const integrate::run::Cursor cursor = integrate::adaptive::start_adaptive(cell.scene, study.solver);
  integrate::run::TurnReport turn;
  for (long i = 1; i <= row.revolutions + 60; ++i) {
    ASSERT_EQ(cursor({}, turn), integrate::run::Outcome::ok);
    EXPECT_TRUE(i <= *row.last_contact_revolution || !turn.touched) << i;
  }
}

}  // namespace
}  // namespace rubsweep::sweep
