#pragma once

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// Starts a run of a scene with torsion, as start_adaptive does for other scenes.
run::Cursor start_twisted(const scene::Scene& scene, const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
