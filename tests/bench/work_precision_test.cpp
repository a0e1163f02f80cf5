#include "bench/work_precision.hpp"

#include <gtest/gtest.h>

#include <array>

#include "bench/reference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::bench {
namespace {

constexpr std::array steppers{integrate::run::Stepper::dopri5, integrate::run::Stepper::rkf78};
constexpr std::array tolerances{1e-5, 1e-9};
const WorkPrecisionOptions few{.turns = 8, .error_turns = 6, .repeats = 2, .seconds_per_variant = 10};

TEST(WorkPrecision, TighterIsMoreWorkAndLessError) {
  const auto scene = test::cell_of({}).scene;
  const auto variants = variants_of(scene, {}, few.turns, steppers, tolerances);
  const auto lines = measure(scene, {}, variants, reference_section(scene, few.error_turns, {}).section, few);
  ASSERT_EQ(lines.size(), 9);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].outcome, integrate::run::Outcome::ok) << i;
    EXPECT_EQ(lines[i].repeats, 2) << i;
    ASSERT_TRUE(lines[i].microseconds_per_revolution) << i;
    EXPECT_GT(*lines[i].microseconds_per_revolution, 0) << i;
  }
  EXPECT_LT(*lines[0].state_error, 1e-11);
  EXPECT_EQ(lines[0].effort.rhs_calls, 0);
  for (std::size_t loose = 1; loose < lines.size(); loose += 2) {
    const auto tight = loose + 1;
    EXPECT_LT(lines[loose].effort.rhs_calls, lines[tight].effort.rhs_calls) << loose;
    if (lines[loose].variant.contact != integrate::run::ContactHandling::located) continue;
    EXPECT_LT(1e2 * *lines[tight].state_error, *lines[loose].state_error) << loose;
    EXPECT_LT(*lines[loose].state_error, 1e-3) << loose;
    EXPECT_EQ(lines[loose].effort.switches, lines[0].effort.switches) << loose;
  }
}

TEST(WorkPrecision, TaylorPiecesAreAsGoodAsTheReference) {
  model::Machine machine = test::machine_of({});
  machine.stops[0].geometry = model::AnnularGeometry{};
  const auto scene = scene::build_cell(machine, 75, scene::WhirlRatio{0.5}).scene;
  const auto variants = variants_of(scene, {}, few.turns, steppers, tolerances);
  const Reference reference = reference_section(scene, few.error_turns, {});
  const auto lines = measure(scene, {}, variants, reference.section, few);
  EXPECT_FALSE(reference.closed_forms);
  EXPECT_LT(*lines[0].state_error, 1e-11);
  EXPECT_GT(lines[0].effort.taylor_turns, 0);
  EXPECT_EQ(lines[0].effort.rhs_calls, 0);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_GT(lines[i].effort.rhs_calls, 0) << i;
    EXPECT_GT(*lines[i].state_error, *lines[0].state_error) << i;
    if (lines[i].variant.relative_tolerance != tolerances.back()) continue;
    EXPECT_GT(lines[i].effort.steps, lines[0].effort.steps) << i;
  }
}

TEST(WorkPrecision, AFailureIsALineWithoutATime) {
  const auto scene = test::cell_of({}).scene;
  integrate::run::SolverOptions base;
  base.max_steps_per_revolution = 100;
  const std::array variants{Variant{integrate::run::Method::adaptive, integrate::run::Stepper::dopri5,
                                    integrate::run::ContactHandling::located, 1e-12}};
  const auto lines = measure(scene, base, variants, std::vector<double>(8), few);
  EXPECT_EQ(lines[0].outcome, integrate::run::Outcome::step_limit);
  EXPECT_FALSE(lines[0].microseconds_per_revolution);
  EXPECT_FALSE(lines[0].state_error);
  EXPECT_EQ(lines[0].repeats, 1);
}

TEST(WorkPrecisionMedian, OfOddAndEvenNumbers) {
  EXPECT_EQ(median({3}), 3);
  EXPECT_EQ(median({9, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 100}), 3);
}

}  // namespace
}  // namespace rubsweep::bench
