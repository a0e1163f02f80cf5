#include "rubsweep/diagnose/inference/diagnosis.hpp"

#include <gtest/gtest.h>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

DiagnosisOptions quick(int threads = 0) {
  DiagnosisOptions options;
  options.cases = few_cases(threads);
  options.most_rounds = 2;
  options.draws_per_round = 200;
  return options;
}

TEST(Diagnosis, AddsMotionsThatResembleTheRecording) {
  DiagnosisOptions options = quick();
  options.least_change = 0;  // no round is spared
  const features::DescribedMotion seen = recorded_case(1, 21);
  const Diagnosis diagnosis = diagnose(small_problem(), seen, options, small_set());
  EXPECT_EQ(diagnosis.history.size(), 3U);
  EXPECT_GT(diagnosis.set.cases.size(), small_set().cases.size());
  EXPECT_GT(diagnosis.posterior.probability(1), 0.8);
  // Their whirl ratios lie closer together than those of the priors.
  constexpr auto unknown = static_cast<std::size_t>(Unknown::whirl_ratio);
  double square[2] = {0, 0}, mean[2] = {0, 0}, count[2] = {0, 0};
  for (const SimulatedCase& one : diagnosis.set.cases) {
    if (one.candidate != 1) continue;
    const int k = one.proposed ? 1 : 0;
    mean[k] += one.unit[unknown];
    square[k] += one.unit[unknown] * one.unit[unknown];
    ++count[k];
  }
  const auto variance = [&](int k) {
    return square[k] / count[k] - mean[k] * mean[k] / (count[k] * count[k]);
  };
  EXPECT_LT(variance(1), variance(0));
}

TEST(Diagnosis, DoesNotDependOnThreads) {
  const features::DescribedMotion seen = recorded_case(1, 22);
  const Diagnosis one = diagnose(small_problem(), seen, quick(1)),
                  three = diagnose(small_problem(), seen, quick(3));
  EXPECT_EQ(one.posterior.probability, three.posterior.probability);
  EXPECT_EQ(one.posterior.weight, three.posterior.weight);
}

TEST(Diagnosis, InterruptedAnswersByTheCasesAtHand) {
  const std::atomic<bool> stop{true};
  DiagnosisOptions options = quick();
  options.cases.stop = &stop;
  const Diagnosis diagnosis = diagnose(small_problem(), recorded_case(0, 23), options, small_set());
  EXPECT_EQ(diagnosis.history.size(), 1U);
  EXPECT_GT(diagnosis.posterior.probability(0), 0.5);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
