#include "rubsweep/analysis/branch/orbits/closed_orbits.hpp"

#include <gtest/gtest.h>

#include "support/annular_scene.hpp"

namespace rubsweep::branch::orbits {
namespace {

/// Full annular rub with a load of its own, and so without symmetry, has an image after a turn of the shaft,
/// but none in the turning frame.
TEST(ClosedOrbits, EachInItsFrame) {
  const SceneFamily family = [](double load) -> std::optional<scene::Scene> {
    scene::Scene scene = test::FullRub{}.scene();
    scene.constant_n(0) = load;
    return scene;
  };
  integrate::exact::modes::ModeCache modes;
  const Eigen::VectorXd section = Eigen::VectorXd::Constant(4, 0.1);
  for (const double load : {0.0, 0.01}) {
    Eigen::VectorXd state = section;
    const OrbitProblem turns = closed_orbits(Closing::with_the_shaft, family, 2, {}, modes);
    EXPECT_EQ(turns.returns(load, state, nullptr), Evaluation::ok);
    EXPECT_EQ(state.size(), 4);
    EXPECT_EQ(turns.order, 2);
    EXPECT_TRUE(turns.half_returns);
  }
  Eigen::VectorXd state(5);
  state << section, 1;
  const OrbitProblem loops = closed_orbits(Closing::in_the_turning_frame, family, 1, {}, modes);
  EXPECT_EQ(loops.returns(0.01, state, nullptr), Evaluation::infeasible);
  EXPECT_NE(loops.returns(0, state, nullptr), Evaluation::infeasible);
  EXPECT_EQ(loops.order, 1);
}

}  // namespace
}  // namespace rubsweep::branch::orbits
