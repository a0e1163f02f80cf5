#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

/// A candidate in which only the whirl ratio and the kick's phase are unknown.
Candidate two_unknowns() {
  Candidate candidate = usual_candidate(Cause::one_side);
  for (Spread& spread : candidate.spreads) spread = {1, 1};
  spread_of(candidate, Unknown::whirl_ratio) = {0, 1};
  spread_of(candidate, Unknown::kick_phase) = {0, 1};
  return candidate;
}

Point at(double whirl, double phase) {
  Point unit{};
  unit[static_cast<std::size_t>(Unknown::whirl_ratio)] = whirl;
  unit[static_cast<std::size_t>(Unknown::kick_phase)] = phase;
  return unit;
}

Proposal proposal() { return {two_unknowns(), {at(0.05, 0.2), at(0.3, 0.9)}, {1, 3}}; }

TEST(CaseSetProposal, HasADensityThatAddsUpToOne) {
  double sum = 0;
  constexpr int n = 200;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) sum += proposal().density(at((i + 0.5) / n, (j + 0.5) / n)) / (n * n);
  EXPECT_NEAR(sum, 1, 2e-3);
}

TEST(CaseSetProposal, DrawsFromItsDensity) {
  RandomStream random(1, 0, 0);
  constexpr int count = 20'000;
  int low = 0;
  for (int k = 0; k < count; ++k) {
    const Point unit = proposal().draw(random);
    for (const double place : unit) {
      ASSERT_GE(place, 0);
      ASSERT_LE(place, 1);
    }
    low += unit[static_cast<std::size_t>(Unknown::whirl_ratio)] < 0.2 ? 1 : 0;
  }
  double expected = 0;
  constexpr int n = 200;
  for (int i = 0; i < n / 5; ++i)
    for (int j = 0; j < n; ++j) expected += proposal().density(at((i + 0.5) / n, (j + 0.5) / n)) / (n * n);
  EXPECT_NEAR(static_cast<double>(low) / count, expected, 0.012);
}

TEST(CaseSetProposal, LeavesKnownNumbersAlone) {
  RandomStream random(2, 0, 0);
  const Point unit = proposal().draw(random);
  EXPECT_EQ(unit[static_cast<std::size_t>(Unknown::friction)], 0);
}

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

TEST(CaseSet, CasesOfACandidateWeighOneTogether) {
  const Eigen::VectorXd weight = importance_weights(small_problem(), small_set());
  double second = 0;
  for (std::size_t i = 0; i < small_set().cases.size(); ++i)
    if (small_set().cases[i].candidate == 1) second += weight(static_cast<Eigen::Index>(i));
  EXPECT_NEAR(second, 1, 1e-12);
  EXPECT_NEAR(weight.sum(), 2, 1e-12);
}

TEST(CaseSet, KeepsTheMeanOfAnUnknownWhateverIsDrawnMoreOften) {
  // Draws without simulation: the weights must cancel the proposal's preference for one corner.
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
