#pragma once

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Which solver a run of `scene` gets.
enum class Solver { adaptive, exact };

/// `automatic`: exact wherever it applies, but for a smoothed contact law, which only the adaptive one knows.
Solver solver_of(const scene::Scene& scene, const run::SolverOptions& options);

/// Starts a run with the solver that `options` ask for.
run::Run start(const scene::Scene& scene, const run::SolverOptions& options, exact::modes::ModeCache& modes);

}  // namespace rubsweep::integrate
