#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(CaseSet, HasCasesEnoughOfEveryCandidate) {
  const CaseSet& set = small_set();
  ASSERT_EQ(set.draws.size(), 2U);
  for (std::size_t c = 0; c < 2; ++c) {
    const auto count = std::ranges::count(set.cases, c, &SimulatedCase::candidate);
    EXPECT_GE(count, 25);
    EXPECT_GE(set.draws[c].count, count);
  }
  for (const SimulatedCase& one : set.cases)
    EXPECT_EQ(one.motion.contact.contact_fraction > 0, one.candidate == 1);
}

TEST(CaseSet, DoesNotDependOnThreads) {
  const CaseSet one = prior_cases(small_problem(), few_cases(1)),
                three = prior_cases(small_problem(), few_cases(3));
  ASSERT_EQ(one.cases.size(), three.cases.size());
  for (std::size_t i = 0; i < one.cases.size(); ++i) {
    EXPECT_EQ(one.cases[i].unit, three.cases[i].unit);
    EXPECT_EQ(one.cases[i].motion.lines.amplitude, three.cases[i].motion.lines.amplitude);
  }
}

TEST(CaseSet, WeighsCandidatesAsThePriorSays) {
  DiagnosisProblem problem = small_problem();
  problem.prior = {0.2, 0.8};
  const Eigen::VectorXd weight = importance_weights(problem, small_set());
  double second = 0;
  for (std::size_t i = 0; i < small_set().cases.size(); ++i)
    if (small_set().cases[i].candidate == 1) second += weight(static_cast<Eigen::Index>(i));
  EXPECT_NEAR(second, 0.8, 1e-12);
  EXPECT_NEAR(weight.sum(), 1, 1e-12);
}

TEST(CaseSet, KeepsTheMeanOfAnUnknownWhateverIsDrawnMoreOften) {
  // Draws without simulation: the weights undo that the proposal favours one corner.
  const DiagnosisProblem problem = small_problem();
  CaseSet set;
  RandomStream random(5, 0, 0);
  const auto add = [&](const Point& unit) { set.cases.push_back({.candidate = 1, .unit = unit}); };
  const Point corner = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
  const Proposal proposal(problem.candidates[1], {corner}, {1});
  constexpr int count = 4000;
  for (int k = 0; k < count; ++k) {
    Point unit{};
    for (double& place : unit) place = random.uniform();
    add(unit);
  }
  for (int k = 0; k < count; ++k) add(proposal.draw(random));
  set.draws = {{1, count, {}}, {1, count, proposal}};
  const Eigen::VectorXd weight = importance_weights(problem, set);
  double mean = 0, plain = 0;
  constexpr auto unknown = static_cast<std::size_t>(Unknown::whirl_ratio);
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    mean += weight(static_cast<Eigen::Index>(i)) / weight.sum() * set.cases[i].unit[unknown];
    plain += set.cases[i].unit[unknown] / static_cast<double>(set.cases.size());
  }
  EXPECT_LT(plain, 0.4);
  EXPECT_NEAR(mean, 0.5, 0.03);
}

TEST(CaseSet, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  CaseOptions options = few_cases();
  options.stop = &stop;
  EXPECT_TRUE(prior_cases(small_problem(), options).cases.empty());
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
