#pragma once

#include "rubsweep/integrate/exact/mode_cache.hpp"
#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate {

/// Starts a run of `scene` by the exact solver: closed forms between mode switches, found by certified steps.
/// A turn that has no closed form (an annular stop touched, friction not saturated, an undamped resonance) is
/// made of Taylor pieces and counted in Effort::taylor_turns; where friction is stiff, or where `options`
/// name a stepper, it is made by that stepper and counted in Effort::adaptive_turns. The run returns to
/// closed forms as soon as the rotor has been free for a turn, or after a while.
run::Run start_hybrid(const scene::Scene& scene, const run::SolverOptions& options, exact::ModeCache& modes);

}  // namespace rubsweep::integrate
