#include "rubsweep/branch/passage.hpp"

#include <gtest/gtest.h>

#include "branch/half_orbit_study.hpp"
#include "rubsweep/branch/settled_start.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::branch {
namespace {

/// Cells at 55, 65, 75, 85 and 95 Hz. The half orbit at a whirl ratio of 0.4 exists between its folds at
/// 61.64546594758 and 90.912861253 Hz.
class Passages : public ::testing::Test {
 protected:
  CellOrbit orbit_of_cell_2() {
    const scene::Cell cell = scene::build_cell(prepared, 75, scene::WhirlRatio{0.4});
    const SettledStart settled = settle_on_orbit(cell, {}, {}, workspace);
    return stable_orbit(study, prepared, 2, *settled.order, settled.section, workspace).value();
  }

  sweep::Study study = test::half_orbit_study({0.4});
  scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  response::motion::Workspace workspace;
};

/// There and back is the same orbit, though by another of its turns perhaps.
TEST_F(Passages, ArriveAndComeBack) {
  const CellOrbit orbit = orbit_of_cell_2();
  EXPECT_EQ(orbit.order, 2);
  EXPECT_EQ(orbit.hits, 1);
  const Passage there = pass(study, prepared, 2, orbit, 3, workspace);
  ASSERT_TRUE(there.arrived);
  EXPECT_EQ(there.parameter, 85);
  EXPECT_GT((there.arrived->state - orbit.state).norm(), 1e-3);
  const Passage back = pass(study, prepared, 3, *there.arrived, 2, workspace);
  ASSERT_TRUE(back.arrived);
  EXPECT_TRUE(same_orbit(study, prepared, 2, orbit, *back.arrived, workspace));
  EXPECT_FALSE(same_orbit(study, prepared, 3, *there.arrived, orbit, workspace));
}

TEST_F(Passages, EndInAFold) {
  const CellOrbit orbit = orbit_of_cell_2();
  const Passage third = pass(study, prepared, 2, orbit, 3, workspace);
  ASSERT_TRUE(third.arrived);
  const Passage up = pass(study, prepared, 3, *third.arrived, 4, workspace);
  EXPECT_FALSE(up.arrived);
  EXPECT_EQ(up.kind, "fold");
  EXPECT_NEAR(up.parameter, 90.912861253, 1e-8);
}

/// Not even where the way begins: what is no orbit is not stable there.
TEST_F(Passages, OfWhatIsNoOrbit) {
  CellOrbit orbit = orbit_of_cell_2();
  EXPECT_TRUE(stable_orbit(study, prepared, 2, 2, orbit.state, workspace));
  orbit.state.setConstant(100);
  EXPECT_FALSE(stable_orbit(study, prepared, 2, 2, orbit.state, workspace));
  const Passage passage = pass(study, prepared, 2, orbit, 3, workspace);
  EXPECT_FALSE(passage.arrived);
  EXPECT_EQ(passage.kind, "stability");
}

}  // namespace
}  // namespace rubsweep::branch
