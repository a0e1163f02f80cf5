#pragma once

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Solver of a run.
enum class Solver { adaptive, exact };

/// `automatic`: the exact solver wherever it applies; a smoothed contact law needs the adaptive solver.
Solver solver_of(const scene::Scene& scene, const run::SolverOptions& options);

/// Starts a run with the solver chosen by `options`.
run::Run start(const scene::Scene& scene, const run::SolverOptions& options, exact::modes::ModeCache& modes);

}  // namespace rubsweep::integrate
