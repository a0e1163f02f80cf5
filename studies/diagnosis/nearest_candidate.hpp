#pragma once

#include <cstddef>
#include <utility>

#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

namespace rubsweep::diagnose {

/// Candidate with the largest share among the cases of the priors that are most like the recording, each
/// feature in units of its spread, and this share: tells whether the candidates differ in the recording at
/// all. Cases count by how likely they are as large as the recording; those that cannot be do not.
std::pair<std::size_t, double> nearest_candidate(const features::DescribedMotion& seen,
                                                 const inference::DiagnosisProblem& problem,
                                                 const inference::Diagnosis& diagnosis);

}  // namespace rubsweep::diagnose
