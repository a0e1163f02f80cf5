#include "rubsweep/integrate/start.hpp"

#include <gtest/gtest.h>

#include "rubsweep/model/rotor_kit.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

TEST(Start, AutoIsExactButForASmoothedLaw) {
  const auto scene = test::cell_of({}).scene;
  SolverOptions options;
  EXPECT_EQ(solver_of(scene, options), Solver::exact);
  options.contact = ContactHandling::smoothed;
  EXPECT_EQ(solver_of(scene, options), Solver::adaptive);
  options.contact = ContactHandling::located;
  options.method = Method::adaptive;
  EXPECT_EQ(solver_of(scene, options), Solver::adaptive);
}

TEST(Start, TheExactSolverTakesTheLargestKit) {
  auto scene = test::cell_of({}).scene;
  const Eigen::Index largest = 2 * model::RotorKit::most_modes + 4 * most_exact_contacts + 1;
  scene.structure.mass.setIdentity(largest, largest);
  ASSERT_EQ(scene.structure.coordinates(), largest);
  EXPECT_TRUE(exact_applies(scene));
  scene.structure.mass.setIdentity(largest + 1, largest + 1);
  EXPECT_FALSE(exact_applies(scene));
}

TEST(Start, ARestartedRunHasNoMemory) {
  const auto scene = test::cell_of({}).scene;
  for (const Method method : {Method::exact, Method::adaptive}) {
    SolverOptions options;
    options.method = method;
    ExactPlans plans;
    const auto run = start(scene, options, plans);
    Turn first, second;
    ASSERT_EQ(run.advance(first), Outcome::ok);
    ASSERT_EQ(run.advance(second), Outcome::ok);
    run.restart(scaled_initial_state(scene));
    Turn again;
    ASSERT_EQ(run.advance(again), Outcome::ok);
    EXPECT_EQ(again.section, first.section);  // the kick with it
  }
}

}  // namespace
}  // namespace rubsweep::integrate
