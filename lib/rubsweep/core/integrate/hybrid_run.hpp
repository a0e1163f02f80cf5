#pragma once

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Starts a run of `scene` with the exact solver: closed forms between mode switches, which are found by
/// certified steps. Between flat stops, Taylor pieces continue a turn in which the friction of a touching
/// contact leaves saturation; closed forms take over again once friction is saturated in either direction. A
/// turn without any closed form (an annular stop touched, an undamped resonance) consists of Taylor pieces
/// from its start. Effort::taylor_turns counts both kinds of turns. If `options` name a stepper or smooth
/// contacts, that stepper makes such turns instead (Effort::adaptive_turns). The run returns to closed forms
/// once the rotor has been free of contact for a turn, or after some turns.
run::Run start_hybrid(const scene::Scene& scene, const run::SolverOptions& options,
                      exact::modes::ModeCache& modes);

}  // namespace rubsweep::integrate
