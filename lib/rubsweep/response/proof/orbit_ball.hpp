#pragma once

#include <optional>
#include <vector>

#include "rubsweep/integrate/exact/mode_cache.hpp"
#include "rubsweep/response/proof/adapted_norm.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response::proof {

/// Radius, in the norms given, of balls about the sections of an orbit inside which every motion converges to
/// it: all motions that start a turn in its ball go through the orbit's own changes of contact mode in their
/// order (integrate::TurnTube), and end it in the next ball, nearer by a factor below 1: the linear map draws
/// them together by `norms.contraction`, and what the turn adds to that is at most nine tenths of what this
/// leaves to 1. `section` is where the orbit's first turn starts. `scene` without a pulse. Empty where a turn
/// has no closed form, a guard is grazed, or no radius above 1e-9 clearances holds.
std::optional<double> ball_radius(const scene::Scene& scene, integrate::exact::ModeCache& modes,
                                  const std::vector<double>& section, const AdaptedNorms& norms);

}  // namespace rubsweep::response::proof
