#pragma once

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Starts a run of `scene` by the exact solver: closed forms between mode switches, found by certified steps.
/// Between flat stops a turn in which the friction of a touching contact leaves saturation is handed on there
/// to Taylor pieces, and back where it is saturated again, either way. A turn that has no closed form at all
/// (an annular stop touched, an undamped resonance) is made of Taylor pieces from its start. Both are counted
/// in Effort::taylor_turns. Where `options` name a stepper or smooth contacts, such a turn is made by that
/// stepper and counted in Effort::adaptive_turns. The run returns to closed forms as soon as the rotor has
/// been free for a turn, or after a while.
run::Run start_hybrid(const scene::Scene& scene, const run::SolverOptions& options,
                      exact::modes::ModeCache& modes);

}  // namespace rubsweep::integrate
