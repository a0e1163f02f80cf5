#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/simulated_case.hpp"

namespace rubsweep::diagnose::inference {

/// How many motions are simulated.
struct CaseOptions {
  int cases_per_candidate = 600;  ///< rubbing cases per candidate, drawn from the priors
  /// limit of the mean number of draws; candidates that rub too rarely get fewer cases
  int most_draws_per_case = 30;
  int threads = 0;                  ///< 0: one thread per processor; does not change the result
  const std::atomic<bool>* stop{};  ///< true: no new draw begins
  std::function<void(std::size_t done, std::size_t all)> on_cases{};  ///< progress; one call at a time
};

/// Simulated cases of all candidates.
struct CaseSet {
  std::vector<SimulatedCase> cases{};
};

/// Draws from the priors until every candidate has its cases or has used up its allowed draws. The result
/// depends on the problem, cases_per_candidate and most_draws_per_case alone.
CaseSet prior_cases(const DiagnosisProblem& problem, const CaseOptions& options);

/// Prior weight of every case among those of its candidate; these weights add up to 1.
Eigen::VectorXd prior_weights(const DiagnosisProblem& problem, const CaseSet& set);

}  // namespace rubsweep::diagnose::inference
