#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"
#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Standard errors of the candidates' probabilities, then of "none of these", due to the limited number of
/// cases. They are standard deviations of the log odds between answers from halves of the cases (delete-half
/// jackknife; Shao, Wu 1989), times p (1 - p) of the answer from all cases. Halves give less certain answers,
/// and the scatter near 0 and 1 depends on p; log odds avoid both. `posterior`: the answer from all cases.
Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                const Posterior& posterior, int threads);

struct DiagnosisOptions {
  CaseOptions cases{};
  int most_rounds = 3;              ///< rounds of draws near cases that resemble the recording
  int draws_per_round = 800;        ///< draws per round, for all candidates together
  bool with_standard_error = true;  ///< computes standard errors where the probabilities still change
  double least_change = 0.03;       ///< change of a probability that calls for another round
};

/// Result of a diagnosis with everything it is based on.
struct Diagnosis {
  CaseSet set{};
  ObservedCases observed{};
  Posterior posterior{};                                   ///< posterior; its forest is dropped at the end
  std::vector<std::vector<QuantityMarginal>> marginals{};  ///< marginals_of for every candidate
  std::vector<Eigen::VectorXd> history{};  ///< probabilities of the candidates after each round
  double p_value = 1;                      ///< result of p_value_of
  bool stands_still = false;               ///< no probability changed by least_change in the last round
  Eigen::VectorXd standard_error{};        ///< sampling_errors if the probabilities still change, or empty
};

/// Compares a recording with simulated cases of all candidates. The cases are first drawn from the priors
/// (`set`: cases already at hand, else prior_cases) and then near those that resemble the recording, until
/// the probabilities settle (population Monte Carlo; Cappé et al. 2004). When interrupted, it answers from
/// the cases drawn by then.
Diagnosis diagnose(const DiagnosisProblem& problem, const features::DescribedMotion& seen,
                   const DiagnosisOptions& options, std::optional<CaseSet> set = {});

/// Weights of the cases of one candidate, zero for all others.
Eigen::VectorXd weights_of(const Diagnosis& diagnosis, std::size_t candidate);

}  // namespace rubsweep::diagnose::inference
