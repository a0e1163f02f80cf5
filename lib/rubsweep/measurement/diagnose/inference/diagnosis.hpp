#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"
#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Standard errors of the probabilities of the candidates, "none of these" counted in, and of that one at
/// last, which come from the number of cases: standard deviation of the answers by halves of the cases
/// (delete-half jackknife; Shao, Wu 1989), of their log odds times p (1 - p) of the answer by all. Halves are
/// less sure, and near 0 and 1 what is left scatters as it is large. `posterior`: that answer.
Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                const Posterior& posterior, int threads);

struct DiagnosisOptions {
  CaseOptions cases{};
  int most_rounds = 3;              ///< rounds of draws near cases that resemble the recording
  int draws_per_round = 800;        ///< draws of all candidates together
  bool with_standard_error = true;  ///< errors where the probabilities do not stand still
  double least_change = 0.03;  ///< change of a probability between two rounds, below which they stand still
};

/// Answer of a diagnosis with all that it rests on.
struct Diagnosis {
  CaseSet set{};
  ObservedCases observed{};
  Posterior posterior{};                                   ///< posterior without its forest
  std::vector<std::vector<QuantityMarginal>> marginals{};  ///< marginals_of every candidate
  std::vector<Eigen::VectorXd> history{};  ///< probabilities of the candidates after each round
  double p_value = 1;                      ///< p_value_of
  bool stands_still = false;               ///< the last round changed them by less than least_change
  Eigen::VectorXd standard_error{};        ///< sampling_errors where they do not stand still; else empty
};

/// Compares a recording with simulated cases of all candidates, which are drawn from the priors at first
/// (`set`: those already at hand, else prior_cases) and then where they resemble it, until the probabilities
/// stand still (population Monte Carlo; Cappé et al. 2004). Interrupted, the answer is that of the cases
/// drawn by then.
Diagnosis diagnose(const DiagnosisProblem& problem, const features::DescribedMotion& seen,
                   const DiagnosisOptions& options, std::optional<CaseSet> set = {});

/// Weights of the cases of one candidate, zero for all others.
Eigen::VectorXd weights_of(const Diagnosis& diagnosis, std::size_t candidate);

}  // namespace rubsweep::diagnose::inference
