// Tests the class that chooses the method for Stepper::automatic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/integrate/adaptive/with.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/rolling_scene.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

struct Finished {
  std::vector<double> section;
  run::Effort effort;
};

Finished run(const scene::Scene& scene, const run::SolverOptions& options, int turns) {
  const run::Cursor advance = start_adaptive(scene, options);
  run::TurnReport turn;
  for (int k = 0; k < turns; ++k) EXPECT_EQ(advance({}, turn), run::Outcome::ok);
  return {turn.section, turn.effort};
}

double difference(const Finished& a, const Finished& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.section.size(); ++i)
    largest = std::max(largest, std::abs(a.section[i] - b.section[i]));
  return largest;
}

TEST(Dopri5OrRosenbrock4AutomaticStepper, IsDopri5ToTheLastBitWhereFrictionIsSaturated) {
  const auto scene = test::cell_of({}).scene;
  const Finished automatic = run(scene, with(run::Stepper::automatic, 1e-8), 6);
  const Finished explicit_only = run(scene, with(run::Stepper::dopri5, 1e-8), 6);
  EXPECT_EQ(automatic.section, explicit_only.section);
  EXPECT_EQ(automatic.effort.rhs_calls, explicit_only.effort.rhs_calls);
  EXPECT_EQ(automatic.effort.implicit_steps, 0);
}

TEST(Dopri5OrRosenbrock4AutomaticStepper, TurnsImplicitInSteepRollingAndSparesMostSteps) {
  const auto rolling = test::rolling_scene(1e5);
  const Finished automatic = run(rolling.scene, with(run::Stepper::automatic, 1e-6), 1);
  const Finished explicit_only = run(rolling.scene, with(run::Stepper::dopri5, 1e-6), 1);
  const Finished reference = run(rolling.scene, with(run::Stepper::rosenbrock4, 1e-9), 1);
  EXPECT_GT(automatic.effort.implicit_steps, automatic.effort.steps / 2);
  EXPECT_LT(automatic.effort.steps, explicit_only.effort.steps / 20);
  EXPECT_EQ(explicit_only.effort.implicit_steps, 0);
  EXPECT_LT(difference(automatic, reference), 1e-4);
  EXPECT_LT(difference(explicit_only, reference), 1e-4);
}

TEST(Dopri5OrRosenbrock4AutomaticStepper, StaysExplicitInGentleRolling) {
  EXPECT_EQ(run(test::rolling_scene(1e2).scene, with(run::Stepper::automatic, 1e-8), 1).effort.implicit_steps,
            0);
}

TEST(Dopri5OrRosenbrock4AutomaticStepper, SamplesInsideImplicitStepsFollowTheClosedForm) {
  const auto rolling = test::rolling_scene(1e5);
  const run::Cursor advance = start_adaptive(rolling.scene, with(run::Stepper::automatic, 1e-6));
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.samples_per_revolution = 50;
  ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
  ASSERT_GT(turn.effort.implicit_steps, 0);
  for (std::size_t k = 0; k < 50; ++k) {
    const auto z = rolling.displacement(static_cast<double>(k) / 50);
    EXPECT_NEAR(turn.samples[4 * k], z.real(), 1e-4);
    EXPECT_NEAR(turn.samples[4 * k + 1], z.imag(), 1e-4);
  }
}

TEST(Dopri5OrRosenbrock4StiffFrictionRatio, GrowsWithTheFourthRootOfTheAccuracy) {
  EXPECT_NEAR(run::stiff_friction_ratio(1e-8), 400, 1e-9);
  EXPECT_NEAR(run::stiff_friction_ratio(1e-4), 40, 1e-10);
}

}  // namespace
}  // namespace rubsweep::integrate::adaptive
