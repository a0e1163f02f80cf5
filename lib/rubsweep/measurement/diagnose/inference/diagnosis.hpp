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
                                const Posterior& posterior, int threads, double evidence_power = 1);

struct DiagnosisOptions {
  CaseOptions cases{};
  bool with_standard_error = true;
};

/// Result of a diagnosis with everything it is based on.
struct Diagnosis {
  CaseSet set{};
  ObservedCases observed{};
  Posterior posterior{};                                   ///< posterior; at the end its forest is deleted
  std::vector<std::vector<QuantityMarginal>> marginals{};  ///< marginals_of for every candidate
  double p_value = 1;                                      ///< result of p_value_of
  Eigen::VectorXd standard_error{};                        ///< sampling_errors; empty if not asked for
};

/// Compares a recording with cases of all candidates that were drawn from the priors (those of `set`, if
/// given). An interrupted diagnosis answers from the cases drawn so far.
Diagnosis diagnose(const DiagnosisProblem& problem, const features::DescribedMotion& seen,
                   const DiagnosisOptions& options, std::optional<CaseSet> set = {});

/// Weights of all cases, with zeros for the cases of other candidates.
Eigen::VectorXd weights_of(const Diagnosis& diagnosis, std::size_t candidate);

}  // namespace rubsweep::diagnose::inference
