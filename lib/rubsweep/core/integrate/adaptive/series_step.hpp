#pragma once

#include <memory>

#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"

namespace rubsweep::integrate::adaptive {

/// Method that makes steps of a run with `law` by power series of a regular time (taylor::RegularExpansion),
/// each as long as they are accurate: to a share of the tolerance, at least to 1e-12. Steps that have no such
/// series, or whose friction is stiff, are made by the stepper of the options. `law` must outlive the method.
template <int N>
std::unique_ptr<StepMethod> make_series_step(const law::Dynamics<N, false>& law,
                                             const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
