#pragma once

#include <Eigen/Core>

#include "rubsweep/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Standard errors of the probabilities of the candidates, "none of these" counted in, and of that one at
/// last, which come from the number of cases: root mean square deviation of the answers by halves of the cases
/// from `posterior`, the answer by all of them (delete-half jackknife; Shao, Wu 1989).
Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                const Posterior& posterior, int threads);

}  // namespace rubsweep::diagnose::inference
