#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/candidate_marginals.hpp"
#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Standard errors of the candidates' probabilities, then of "none of these", due to the limited number of
/// cases. They come from answers to random halves of the cases (delete-half jackknife; Shao, Wu 1989): the
/// standard deviation of the log odds times p (1 - p), with p from all cases. Log odds are used because
/// halves give less certain answers, and because the scatter of p itself shrinks near 0 and 1. `posterior`:
/// the answer from all cases.
Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                const Posterior& posterior, int threads);

struct DiagnosisOptions {
  CaseOptions cases{};
  int most_rounds = 3;              ///< rounds of draws near cases that resemble the recording
  int draws_per_round = 800;        ///< draws per round, for all candidates together
  bool with_standard_error = true;  ///< computes standard errors where the probabilities still change
  double least_change = 0.03;       ///< a smaller change of all probabilities ends the rounds
};

/// Result of a diagnosis with everything it is based on.
struct Diagnosis {
  CaseSet set{};
  ObservedCases observed{};
  Posterior posterior{};                                   ///< posterior; at the end its forest is deleted
  std::vector<std::vector<QuantityMarginal>> marginals{};  ///< marginals_of for every candidate
  std::vector<Eigen::VectorXd> history{};  ///< probabilities of the candidates after each round
  double p_value = 1;                      ///< result of p_value_of
  /// whether the last round changed no probability by least_change or more
  bool stands_still = false;
  Eigen::VectorXd standard_error{};  ///< sampling_errors; empty if the probabilities no longer change
};

/// Compares a recording with simulated cases of all candidates. The first cases are drawn from the priors (or
/// are those of `set`, if given). Later cases are drawn near those that resemble the recording, until the
/// probabilities settle (population Monte Carlo; Cappé et al. 2004). An interrupted diagnosis answers from
/// the cases drawn so far.
Diagnosis diagnose(const DiagnosisProblem& problem, const features::DescribedMotion& seen,
                   const DiagnosisOptions& options, std::optional<CaseSet> set = {});

/// Weights of all cases, with zeros for the cases of other candidates.
Eigen::VectorXd weights_of(const Diagnosis& diagnosis, std::size_t candidate);

}  // namespace rubsweep::diagnose::inference
