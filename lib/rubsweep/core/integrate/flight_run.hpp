#pragma once

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Whether `start_flights` takes the scene: contacts of which some have no linear law, without torsion and
/// impulses, and a solver that nothing but `auto` names.
bool may_fly(const scene::Scene& scene, const run::SolverOptions& options);

/// Starts a run that flies by closed forms, which pass over no touching, while all contacts are open. From
/// the first touching to the opening of the last contact a stepper makes it.
run::Run start_flights(const scene::Scene& scene, const run::SolverOptions& options,
                       exact::modes::ModeCache& modes);

}  // namespace rubsweep::integrate
