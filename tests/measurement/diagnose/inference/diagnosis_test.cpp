#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

DiagnosisOptions quick(int threads = 0) {
  DiagnosisOptions options;
  options.cases = few_cases(threads);
  return options;
}

TEST(Diagnosis, SharesItsWeightsAmongTheCandidates) {
  const Diagnosis diagnosis = diagnose(small_problem(), recorded_case(1, 21), quick(), small_set());
  const Eigen::VectorXd first = weights_of(diagnosis, 0), second = weights_of(diagnosis, 1);
  EXPECT_EQ(first + second, diagnosis.posterior.weight);
  EXPECT_EQ(first.cwiseProduct(second).maxCoeff(), 0);
  EXPECT_NEAR(second.sum(), diagnosis.posterior.probability(1), 0.01);
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
  EXPECT_GT(diagnosis.posterior.probability(0), 0.5);
}

TEST(Diagnosis, TakesARecordingThatResemblesNoCaseForWeakEvidence) {
  DiagnosisOptions options = quick();
  features::DescribedMotion strange = recorded_case(1, 23);
  for (features::Feature& feature : strange.features) feature.value += 1;
  for (const auto& seen : {recorded_case(1, 23), strange}) {
    const Diagnosis diagnosis = diagnose(small_problem(), seen, options, small_set());
    const bool usual = seen.features.front().value != strange.features.front().value;
    EXPECT_EQ(diagnosis.p_value > 0.05, usual) << diagnosis.p_value;
    const Posterior alone = posterior_of(small_problem(), small_set(), diagnosis.observed, seen, 0,
                                         evidence_power_of(diagnosis.p_value));
    EXPECT_EQ(diagnosis.posterior.probability, alone.probability);
    EXPECT_EQ(diagnosis.posterior.none, alone.none);
  }
}

TEST(Diagnosis, IsTheScatterOfAnswersByOtherCases) {
  // The same problem with other random numbers: the scatter of the answers must agree with the prediction
  // from halves, also near certainty, where halves are less certain.
  constexpr int sets = 16;
  const std::array recordings{recorded_case(1, 50), recorded_case(1, 33)};
  std::array<double, recordings.size()> sum{}, square{}, foretold{};
  for (int k = 0; k < sets; ++k) {
    DiagnosisProblem problem = small_problem();
    problem.seed = 100 + static_cast<std::uint64_t>(k);
    const CaseSet set = prior_cases(problem, few_cases());
    const ObservedCases observed = observed_cases(problem, set, 0);
    for (std::size_t r = 0; r < recordings.size(); ++r) {
      const Posterior posterior = posterior_of(problem, set, observed, recordings[r], 0);
      const double p = (1 - posterior.none) * posterior.probability(1);
      const Eigen::VectorXd error = sampling_errors(problem, set, observed, recordings[r], posterior, 0);
      ASSERT_EQ(error.size(), 3);
      if (k == 0) {
        EXPECT_EQ(error, sampling_errors(problem, set, observed, recordings[r], posterior, 1));
      }
      sum[r] += p / sets;
      square[r] += p * p / sets;
      foretold[r] += error(1) / sets;
    }
  }
  EXPECT_GT(sum[1], 0.98);
  EXPECT_LT(sum[0], 0.96);
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const double scatter = std::sqrt((square[r] - sum[r] * sum[r]) * sets / (sets - 1.0));
    EXPECT_GT(foretold[r], scatter / 2);
    EXPECT_LT(foretold[r], scatter * 2);
  }
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
