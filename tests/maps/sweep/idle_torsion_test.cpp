#include "rubsweep/maps/sweep/idle_torsion.hpp"

#include <gtest/gtest.h>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

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

TEST(IdleTorsionWhyIs, SaysSoWhereNoFrictionAsksForTheSlip) {
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

TEST(IdleTorsionWhyIs, AsksEveryStop) {
  // The smaller of two radii changes the slip by less and by more of itself.
  model::Machine machine = twisting(model::OneWayFriction{0.005});
  machine.stops.push_back(machine.stops[0]);
  machine.stops[1].contact_radius_m *= 0.4;
  machine.stops[1].friction = model::OneWayFriction{0.025};
  ASSERT_NE(why_torsion_is_idle(scene::prepare_machine(machine), 50), "");
  machine.stops[1].friction = model::OneWayFriction{0.1};
  EXPECT_EQ(why_torsion_is_idle(scene::prepare_machine(machine), 50), "");
}

/// The statement is true: the row is nearly that of the rotor without torsion.
TEST(IdleTorsionWhyIs, TheMotionIsTheSameWithoutTorsion) {
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

}  // namespace
}  // namespace rubsweep::sweep
