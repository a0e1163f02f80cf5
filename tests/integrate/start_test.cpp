#include "rubsweep/integrate/start.hpp"

#include <gtest/gtest.h>

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
