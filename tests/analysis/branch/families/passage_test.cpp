#include "rubsweep/analysis/branch/families/passage.hpp"

#include <gtest/gtest.h>

#include "analysis/branch/families/half_orbit_study.hpp"
#include "core/response/annular_cell.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::branch::families {
namespace {

/// Cells at 55, 65, 75, 85 and 95 Hz. The half orbit at a whirl ratio of 0.4 exists between its folds at
/// 61.64546594758 and 90.912861253 Hz.
class Passages : public ::testing::Test {
 protected:
  CellOrbit orbit_of_cell_2() {
    const scene::Cell cell = scene::build_cell(prepared, 75, scene::WhirlRatio{0.4});
    const orbits::SettledStart settled = orbits::settle_on_orbit(cell, {}, {}, workspace);
    return stable_orbit(study, prepared, 2, settled, workspace).value();
  }

  sweep::Study study = test::half_orbit_study({0.4});
  scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  response::motion::Workspace workspace;
};

/// Going to the next cell and back gives the same orbit, possibly at another of its turns.
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

/// In the annulus of figure 11 at 82.5 Hz, an oval with four impacts becomes twice an oval with two impacts.
/// Its branch ends there and continues into no further cell. The oval of half the period has its period
/// doubling at that place.
TEST(PassagesOfOvals, EndWhereTheyHalveTheirPeriod) {
  sweep::Study study;
  study.machine = response::testing::annular_machine();
  model::Stop& stop = study.machine.stops.front();
  stop.stiffness_n_per_m = 5e6;
  stop.casing->stiffness_n_per_m = 2e5;
  stop.casing->damping_ratio = 0.4;
  study.machine.rotor =
      model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
  study.machine.kick->force_n = 45;
  study.grid.speed_hz = {82.5};
  study.grid.unbalance = {0.66, 0.74};
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  response::motion::Workspace workspace;
  const auto orbit_at = [&](double whirl_ratio, std::size_t cell) {
    const scene::Cell start = scene::build_cell(prepared, 82.5, scene::WhirlRatio{whirl_ratio});
    return stable_orbit(study, prepared, cell, orbits::settle_on_orbit(start, {}, study.response, workspace),
                        workspace);
  };
  const auto orbit = orbit_at(0.66, 0);
  ASSERT_TRUE(orbit);
  EXPECT_EQ(orbit->closing, orbits::Closing::in_the_turning_frame);
  EXPECT_EQ(orbit->hits, 4);
  EXPECT_TRUE(same_orbit(study, prepared, 0, *orbit, *orbit, workspace));
  const Passage passage = pass(study, prepared, 0, *orbit, 1, workspace);
  EXPECT_FALSE(passage.arrived);
  EXPECT_EQ(passage.kind, "period_halving");
  EXPECT_NEAR(passage.parameter, 0.723571651272, 1e-10);
}

/// A state on no orbit fails already at the start, because it is not stable there.
TEST_F(Passages, OfWhatIsNoOrbit) {
  CellOrbit orbit = orbit_of_cell_2();
  orbits::SettledStart settled{response::motion::MotionClass::subharmonic, 2, orbits::Closing::with_the_shaft,
                               orbit.state};
  EXPECT_TRUE(stable_orbit(study, prepared, 2, settled, workspace));
  orbit.state.setConstant(100);
  settled.state = orbit.state;
  EXPECT_FALSE(stable_orbit(study, prepared, 2, settled, workspace));
  settled.order.reset();
  EXPECT_FALSE(stable_orbit(study, prepared, 2, settled, workspace));
  const Passage passage = pass(study, prepared, 2, orbit, 3, workspace);
  EXPECT_FALSE(passage.arrived);
  EXPECT_EQ(passage.kind, "stability");
}

}  // namespace
}  // namespace rubsweep::branch::families
