// Every hard scene by every solver: it must end with the right answer, or with a named outcome where there is
// none. The answer comes from a closed form, a conservation law, hand-written equations in long double, or
// another kind of stepper at a tighter tolerance.
#include "hard_cases/hard_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/integrate/start.hpp"

namespace rubsweep::test {
namespace {

using integrate::run::SolverOptions;
using integrate::run::Stepper;

struct Solver {
  std::string_view name;
  SolverOptions options;
};

SolverOptions with(Stepper stepper, double tolerance) {
  SolverOptions options;
  options.method = integrate::run::Method::adaptive;
  options.stepper = stepper;
  options.relative_tolerance = tolerance;
  return options;
}

/// Tight tolerance, but loose enough that a method of low order does not need a million steps.
double tolerance_of(Stepper stepper) {
  switch (stepper) {
    case Stepper::cash_karp54: return 1e-8;
    case Stepper::rosenbrock4: return 1e-6;
    default: return 1e-10;
  }
}

std::vector<Solver> solvers() {
  SolverOptions exact = with(Stepper::automatic, 1e-10);
  exact.method = integrate::run::Method::exact;
  std::vector<Solver> all{{"exact", exact},
                          {"auto", with(Stepper::automatic, 1e-8)},
                          {"auto, loose", with(Stepper::automatic, 1e-6)}};
  for (const Stepper stepper : integrate::adaptive::single_steppers())
    all.push_back({integrate::adaptive::row_of(stepper).word, with(stepper, tolerance_of(stepper))});
  return all;
}

struct Found {
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  std::vector<double> section;
  int hits = 0;
  bool slip_reversed = false;
};

Found run(const HardScene& hard, const SolverOptions& options) {
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Cursor advance = integrate::start(hard.scene, options, modes).advance;
  integrate::run::TurnReport turn;
  Found result;
  for (int k = 0; k < hard.turns && result.outcome == integrate::run::Outcome::ok; ++k) {
    result.outcome = advance({}, turn);
    result.hits += turn.hits;
    result.slip_reversed = result.slip_reversed || turn.slip_reversed;
  }
  result.section = turn.section;
  return result;
}

class HardScenes : public testing::TestWithParam<NamedHardScene> {};

INSTANTIATE_TEST_SUITE_P(All, HardScenes, testing::ValuesIn(hard_scenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

TEST_P(HardScenes, AnswerOfEverySolver) {
  const HardScene hard = GetParam().make();
  const std::vector<double> answer =
      hard.section.empty() ? run(hard, with(Stepper::rkf78, 1e-12)).section : hard.section;
  for (const Solver& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    const Found found = run(hard, solver.options);
    ASSERT_EQ(integrate::run::to_string(found.outcome), "ok");
    const double error =
        integrate::largest_difference(found.section, answer) / solver.options.relative_tolerance;
    EXPECT_LT(error, hard.error_per_tolerance);
    EXPECT_EQ(found.hits, hard.hits.value_or(found.hits));
    if (hard.energy_j) {
      const double share = stored_energy_j(hard.scene, found.section) / *hard.energy_j - 1;
      EXPECT_LT(std::abs(share), 500 * solver.options.relative_tolerance);
    }
  }
  // The smoothed law has another answer; its run must end as well.
  SolverOptions smoothed = with(Stepper::automatic, 1e-6);
  smoothed.contact = integrate::run::ContactHandling::smoothed;
  EXPECT_EQ(integrate::run::to_string(run(hard, smoothed).outcome), "ok");
}

TEST(HardScenes, EverySolverNoticesASlipThatReversesUnderOneWayFriction) {
  HardScene hard = slip_reversal();
  for (const Solver& solver : solvers()) {
    SCOPED_TRACE(solver.name);
    hard.scene.contacts[0].friction = model::OneWayFriction{0.1};
    EXPECT_TRUE(run(hard, solver.options).slip_reversed);
    hard.scene.contacts[0].friction = model::ConstantFriction{0.1};
    EXPECT_FALSE(run(hard, solver.options).slip_reversed);
  }
}

}  // namespace
}  // namespace rubsweep::test
