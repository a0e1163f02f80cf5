#pragma once

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// Starts a run of `scene` with one of Odeint's steppers; the scene need not outlive the call. The
/// specialised model (stepper, number of coordinates, contact handling) is chosen here, once. Throws
/// SolverError for a number that is not a stepper.
run::Cursor start_adaptive(const scene::Scene& scene, const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
