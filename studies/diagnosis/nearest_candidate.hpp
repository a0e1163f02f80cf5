#pragma once

#include <cstddef>
#include <utility>

#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"

namespace rubsweep::diagnose {

/// Candidate with the largest share among the prior cases closest to the recording, with features in units of
/// their spread, and this share. It shows whether the recording can distinguish the candidates at all. Cases
/// are weighted by the probability of the recording's size.
std::pair<std::size_t, double> nearest_candidate(const features::DescribedMotion& seen,
                                                 const inference::DiagnosisProblem& problem,
                                                 const inference::Diagnosis& diagnosis);

}  // namespace rubsweep::diagnose
