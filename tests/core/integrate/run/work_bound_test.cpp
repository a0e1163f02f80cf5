#include "rubsweep/core/integrate/run/work_bound.hpp"

#include <gtest/gtest.h>

namespace rubsweep::integrate::run {
namespace {

TEST(WorkBound, PiecesAreStepsThatCostMore) {
  const Effort closed{.steps = 70};
  EXPECT_EQ(work(closed), 140);
  const Effort with_pieces{.steps = 70, .taylor_pieces = 30, .taylor_work = 45};
  EXPECT_EQ(work(with_pieces), 2 * 40 + 50 * 45);
  const Effort adaptive{.rhs_calls = 600, .steps = 90, .refused = 10};
  EXPECT_EQ(work(adaptive), 600 + 2 * 100);
}

TEST(WorkBound, ALargerLimitOfATurnRaisesAllOthersAndASmallerOneShortensNoRun) {
  const SolverOptions usual;
  SolverOptions more, fewer;
  more.max_steps_per_revolution = 7 * usual.max_steps_per_revolution;
  fewer.max_steps_per_revolution = SolverOptions::max_steps_low;
  EXPECT_EQ(most_pieces_of_a_turn(more), 7 * most_pieces_of_a_turn(usual));
  EXPECT_EQ(most_evaluations_of_a_turn(more), 7 * most_evaluations_of_a_turn(usual));
  EXPECT_EQ(most_work_of_a_run(more, 4), 7 * most_work_of_a_run(usual, 4));
  EXPECT_EQ(most_pieces_of_a_turn(fewer), SolverOptions::max_steps_low);
  EXPECT_EQ(most_work_of_a_run(fewer, 4), most_work_of_a_run(usual, 4));
}

TEST(WorkBound, EvaluationsOfLargerSystemsTakeLonger) {
  EXPECT_EQ(most_work_of_a_run({}, 2), most_work_of_a_run({}, 4));
  EXPECT_EQ(3 * most_work_of_a_run({}, 12), most_work_of_a_run({}, 4));
}

TEST(WorkBound, NoTurnAloneReachesTheBoundOfItsRun) {
  const SolverOptions usual;
  const long most = most_pieces_of_a_turn(usual);
  const Effort pieces{.steps = most, .taylor_pieces = most, .taylor_work = static_cast<double>(most)};
  EXPECT_LT(work(pieces), most_work_of_a_run(usual, 4));
  const Effort adaptive{.rhs_calls = most_evaluations_of_a_turn(usual),
                        .steps = usual.max_steps_per_revolution};
  EXPECT_LE(work(adaptive), most_work_of_a_run(usual, 4));
}

TEST(WorkBoundBudget, IsUsedUpByWhatWasSpent) {
  WorkBudget budget(10);
  budget.spend(9);
  EXPECT_FALSE(budget.used_up());
  budget.spend(1);
  EXPECT_TRUE(budget.used_up());
}

}  // namespace
}  // namespace rubsweep::integrate::run
