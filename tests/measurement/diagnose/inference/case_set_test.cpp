#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(CaseSet, HasCasesEnoughOfEveryCandidate) {
  const CaseSet& set = small_set();
  for (std::size_t c = 0; c < 2; ++c)
    EXPECT_GE(std::ranges::count(set.cases, c, &SimulatedCase::candidate), 25);
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
  const Eigen::VectorXd weight = prior_weights(small_problem(), small_set());
  double second = 0;
  for (std::size_t i = 0; i < small_set().cases.size(); ++i)
    if (small_set().cases[i].candidate == 1) second += weight(static_cast<Eigen::Index>(i));
  EXPECT_NEAR(second, 1, 1e-12);
  EXPECT_NEAR(weight.sum(), 2, 1e-12);
}

TEST(CaseSet, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  CaseOptions options = few_cases();
  options.stop = &stop;
  EXPECT_TRUE(prior_cases(small_problem(), options).cases.empty());
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
