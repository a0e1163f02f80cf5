#pragma once

#include "rubsweep/integrate/exact.hpp"
#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate {

/// Which solver a run of `scene` gets.
enum class Solver { adaptive, exact };

/// `automatic`: exact wherever it applies, but for a smoothed contact law, which only the adaptive one knows.
Solver solver_of(const scene::Scene& scene, const SolverOptions& options);

/// Starts a run with the solver that `options` ask for.
Run start(const scene::Scene& scene, const SolverOptions& options, ExactPlans& plans);

}  // namespace rubsweep::integrate
