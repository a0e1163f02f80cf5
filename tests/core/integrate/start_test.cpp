#include "rubsweep/core/integrate/start.hpp"

#include <gtest/gtest.h>

#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

TEST(Start, AutoIsExactButForASmoothedLaw) {
  const auto scene = test::cell_of({}).scene;
  run::SolverOptions options;
  EXPECT_EQ(solver_of(scene, options), Solver::exact);
  options.contact = run::ContactHandling::smoothed;
  EXPECT_EQ(solver_of(scene, options), Solver::adaptive);
  options.contact = run::ContactHandling::located;
  options.method = run::Method::adaptive;
  EXPECT_EQ(solver_of(scene, options), Solver::adaptive);
}

TEST(Start, TheExactSolverTakesTheLargestKit) {
  auto scene = test::cell_of({}).scene;
  const Eigen::Index largest = 2 * model::RotorKit::most_modes + 4 * exact::modes::most_exact_contacts + 1;
  scene.structure.mass.setIdentity(largest, largest);
  ASSERT_EQ(scene.structure.coordinates(), largest);
  EXPECT_TRUE(exact::modes::exact_applies(scene));
  scene.structure.mass.setIdentity(largest + 1, largest + 1);
  EXPECT_FALSE(exact::modes::exact_applies(scene));
}

TEST(Start, ARestartedRunHasNoMemory) {
  const auto scene = test::cell_of({}).scene;
  for (const run::Method method : {run::Method::exact, run::Method::adaptive}) {
    run::SolverOptions options;
    options.method = method;
    exact::modes::ModeCache modes;
    const auto run = start(scene, options, modes);
    run::TurnReport first, second;
    ASSERT_EQ(run.advance({}, first), run::Outcome::ok);
    ASSERT_EQ(run.advance({}, second), run::Outcome::ok);
    run.restart(run::scaled_initial_state(scene));
    run::TurnReport again;
    ASSERT_EQ(run.advance({}, again), run::Outcome::ok);
    EXPECT_EQ(again.section, first.section);  // including the kick
  }
}

}  // namespace
}  // namespace rubsweep::integrate
