#pragma once

#include <cstddef>
#include <utility>

#include "rubsweep/diagnose/inference/diagnosis.hpp"

namespace rubsweep::diagnose {

/// Largest share of one candidate among the cases of the priors that are most like the recording, each
/// feature in units of its spread, and that candidate: tells whether the candidates differ in this recording
/// at all. Cases count by how likely they are as large as the recording; those that cannot be are none.
std::pair<std::size_t, double> nearest_candidate(const features::DescribedMotion& seen,
                                                 const inference::DiagnosisProblem& problem,
                                                 const inference::Diagnosis& diagnosis);

}  // namespace rubsweep::diagnose
