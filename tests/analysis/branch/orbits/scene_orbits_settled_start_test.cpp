#include <gtest/gtest.h>

#include "core/response/annular_cell.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::branch::orbits {
namespace {

/// A cell of parameter set A that settles on a half orbit, and its branch, which is closed and stable between
/// its folds on one side. In a map of 4000 cells along the line, the folds lie in the same intervals.
TEST(SceneOrbitsSettledStart, AHalfOrbitAndItsClosedBranch) {
  response::motion::Workspace workspace;
  test::OneSideRotor rotor;
  const scene::Cell cell = test::cell_of(rotor);
  const SettledStart settled = settle_on_orbit(cell, {}, {}, workspace);
  ASSERT_EQ(settled.order, 2);
  OrbitProblem problem = scene_orbits(
      [rotor](double speed_hz) -> std::optional<scene::Scene> {
        test::OneSideRotor at = rotor;
        at.speed_hz = speed_hz;
        return test::cell_of(at).scene;
      },
      2, {}, workspace.modes);
  problem.low = 45;
  problem.high = 240;
  problem.parameter_scale = 195;
  const auto start = continuation::orbit_from(problem, settled.state, rotor.speed_hz);
  ASSERT_TRUE(start);
  EXPECT_TRUE(start->stable());
  const continuation::Branch branch = continuation::follow_both_ways(problem, *start, {});
  EXPECT_EQ(branch.rising, continuation::Ending::closed);
  ASSERT_EQ(branch.events.size(), 2u);
  for (const continuation::BranchEvent& event : branch.events) {
    EXPECT_EQ(event.kind, continuation::EventKind::fold);
    EXPECT_LT(event.parameter_error, 1e-10 * event.point.parameter);
    EXPECT_NEAR(std::abs(event.point.multipliers(0)), 1, 1e-4);
  }
}

/// Tests both ways in which an orbit can close.
TEST(SceneOrbitsSettledStart, ACircleAndAnOvalInAnAnnulus) {
  response::motion::Workspace workspace;
  const SettledStart circle = settle_on_orbit(response::testing::annular_cell(80, 0.6), {}, {}, workspace);
  EXPECT_EQ(circle.order, 1);
  EXPECT_EQ(circle.closing, Closing::with_the_shaft);
  EXPECT_EQ(circle.state.size(), 8);
  const SettledStart oval = settle_on_orbit(response::testing::annular_cell(165, 0.6), {}, {}, workspace);
  EXPECT_EQ(oval.order, 1);
  EXPECT_EQ(oval.closing, Closing::in_the_turning_frame);
  EXPECT_EQ(oval.state.size(), 9) << "with its time";
}

TEST(SceneOrbitsSettledStart, ARotorThatComesToRestHasNoOrbit) {
  response::motion::Workspace workspace;
  test::OneSideRotor rotor;
  rotor.kick_n = 1;
  const SettledStart settled = settle_on_orbit(test::cell_of(rotor), {}, {}, workspace);
  EXPECT_FALSE(settled.order);
  EXPECT_EQ(settled.motion_class, response::motion::MotionClass::non_contact);
}

std::optional<Eigen::VectorXd> oval_of(const scene::Cell& cell) {
  response::motion::Workspace workspace;
  response::motion::ResponseOptions options;
  options.max_revolutions = 60;
  options.window_revolutions = 24;  // a run contains two windows
  const response::SettledRun settled = response::settle(cell, {}, options, workspace);
  const Eigen::Map<const Eigen::VectorXd> section(settled.section.data(),
                                                  static_cast<Eigen::Index>(settled.section.size()));
  return oval_from(cell.scene, section, {}, options, workspace);
}

/// The period agrees with the comb of a long run, see RotatingProof; the state is at the largest distance
/// from the axis.
TEST(SceneOrbitsSettledStart, OfAnOvalItsFarthestPointAndPeriod) {
  const scene::Cell cell = response::testing::annular_cell(165, 0.6);
  const auto state = oval_of(cell);
  ASSERT_TRUE(state);
  ASSERT_EQ(state->size(), 9);
  const auto& map = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  const Eigen::Vector2d z = map * state->head(4), v = map * state->segment(4, 4);
  EXPECT_NEAR(z.dot(v), 0, 1e-9);
  EXPECT_GT(z.norm(), 1) << "it touches";
  EXPECT_GT((*state)(8), 0);
}

TEST(SceneOrbitsSettledStart, NoneOfACircleNorWithoutSymmetry) {
  EXPECT_FALSE(oval_of(response::testing::annular_cell(80, 0.6)));
  EXPECT_FALSE(oval_of(response::testing::annular_cell(165, 0.6, 2e-4)));
}

}  // namespace
}  // namespace rubsweep::branch::orbits
