#include "rubsweep/diagnose/inference/sampling_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "small_problem.hpp"

namespace rubsweep::diagnose::inference {
namespace {

double error_of_second(const DiagnosisProblem& problem, const CaseSet& set) {
  const features::DescribedMotion seen = recorded_case(1, 31);
  ObservedCases observed;
  observe_cases(problem, set, 0, observed);
  const Eigen::VectorXd error = sampling_errors(problem, set, observed, seen, 0);
  EXPECT_EQ(error.size(), 3);
  EXPECT_EQ(error, sampling_errors(problem, set, observed, seen, 1));
  return error(1);
}

TEST(SamplingError, IsTheScatterOfAnswersByOtherCases) {
  // The same problem with other random numbers: the scatter of the answers is what the halves foretell.
  constexpr int sets = 10;
  double sum = 0, square = 0, foretold = 0;
  for (int k = 0; k < sets; ++k) {
    DiagnosisProblem problem = small_problem();
    problem.seed = 100 + static_cast<std::uint64_t>(k);
    const CaseSet set = prior_cases(problem, few_cases());
    ObservedCases observed;
    observe_cases(problem, set, 0, observed);
    const Posterior posterior = posterior_of(problem, set, observed, recorded_case(1, 31), 0);
    const double p = (1 - posterior.none) * posterior.probability(1);
    sum += p / sets;
    square += p * p / sets;
    foretold += error_of_second(problem, set) / sets;
  }
  const double scatter = std::sqrt((square - sum * sum) * sets / (sets - 1.0));
  EXPECT_GT(foretold, scatter / 2.5);
  EXPECT_LT(foretold, scatter * 2.5);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
