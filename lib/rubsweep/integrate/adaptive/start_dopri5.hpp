#pragma once

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// Starts a run of `scene` with dopri5, or with rosenbrock4 in stiff friction where the stepper is
/// `automatic`. This is the default, so that the number of coordinates is fixed at compile time where it is
/// one of the usual ones.
run::Cursor start_dopri5(const scene::Scene& scene, const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
