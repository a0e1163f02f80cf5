#pragma once

#include "rubsweep/diagnose/inference/simulated_case.hpp"

namespace rubsweep::diagnose::inference {

/// Density of the logarithm of a case's size at that of the recording, over that of a size which goes by the
/// candidate's clearances alone. These are drawn evenly in their logarithm: those that the size asks for
/// count alike, others not at all. A quiet whirl counts by its whirl ratios. A known unbalance says the size
/// of a case as well.
double density_of_size(const DiagnosisProblem& problem, const SimulatedCase& one, double case_size_m,
                       double seen_size_m);

}  // namespace rubsweep::diagnose::inference
