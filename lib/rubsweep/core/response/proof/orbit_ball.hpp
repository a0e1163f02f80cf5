#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"
#include "rubsweep/core/response/proof/approach.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::proof {

/// Radius, in the norms given, of balls about the sections of an orbit inside which every motion converges to
/// it: all motions that start a turn in its ball go through the orbit's own changes of contact mode in their
/// order (integrate::TurnTube), and end it in the next ball, nearer by a factor below 1: the linear map
/// contracts by `norms.contraction`, and the nonlinear deviation is at most nine tenths of the difference to
/// 1. `section` is where the orbit's first turn starts. `scene` without a pulse. Empty where a turn has no
/// closed form, a guard is grazed, or no radius above 1e-9 clearances holds.
std::optional<double> ball_radius(const scene::Scene& scene, integrate::exact::modes::ModeCache& modes,
                                  const std::vector<double>& section, const AdaptedNorms& norms);

/// Radii of the two parts of `norms` for sets about the sections with the same property: the ball of the norm
/// max(|fast| / radii.fast, |slow| / radii.slow). Among several ratios of the radii it is the one whose set a
/// motion at `distance` from the orbit is expected to enter first.
std::optional<integrate::exact::tube::Parts> split_ball_radii(const scene::Scene& scene,
                                                              integrate::exact::modes::ModeCache& modes,
                                                              const std::vector<double>& section,
                                                              const SplitNorms& norms,
                                                              const integrate::exact::tube::Parts& distance);

/// Turns that both parts need from `distance` to `radii` by the contraction of their norms.
double turns_to_enter(const SplitNorms& norms, const integrate::exact::tube::Parts& distance,
                      const integrate::exact::tube::Parts& radii);

}  // namespace rubsweep::response::proof
