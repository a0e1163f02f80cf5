#pragma once

#include <Eigen/Core>

#include "rubsweep/diagnose/inference/posterior.hpp"

namespace rubsweep::diagnose::inference {

/// Standard errors of the probabilities of the candidates, "none of these" counted in, and of that one at
/// last, which come from the number of cases: standard deviation of the answers by halves of the cases
/// (delete-half jackknife; Shao, Wu 1989).
Eigen::VectorXd sampling_errors(const DiagnosisProblem& problem, const CaseSet& set,
                                const ObservedCases& observed, const features::DescribedMotion& seen,
                                int threads);

}  // namespace rubsweep::diagnose::inference
