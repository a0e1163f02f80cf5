#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"
#include "rubsweep/core/response/proof/approach.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::proof {

/// Radius, in the given norms, of balls about the sections of an orbit inside which every motion converges to
/// the orbit. All motions that start a turn in its ball pass the orbit's own changes of contact mode in the
/// same order (integrate::TurnTube), and end in the next ball, nearer to the orbit by a factor below 1. For
/// this, the linear map contracts by `norms.contraction`, and the nonlinear deviation is at most nine tenths
/// of the difference between this contraction and 1. `section` is the start of the orbit's first turn;
/// `scene` has no pulse. Empty where a turn has no closed form, a guard is grazed, or no radius above 1e-9
/// clearances is possible.
std::optional<double> ball_radius(const scene::Scene& scene, integrate::exact::modes::ModeCache& modes,
                                  const std::vector<double>& section, const AdaptedNorms& norms);

/// Radii of the two parts of `norms` with the same property: the ball is that of the norm max(|fast| /
/// radii.fast, |slow| / radii.slow). Of several ratios of the radii, the one is chosen whose ball a motion at
/// `distance` from the orbit should enter first.
std::optional<integrate::exact::tube::Parts> split_ball_radii(const scene::Scene& scene,
                                                              integrate::exact::modes::ModeCache& modes,
                                                              const std::vector<double>& section,
                                                              const SplitNorms& norms,
                                                              const integrate::exact::tube::Parts& distance);

/// Number of turns to shrink both parts from `distance` to `radii` by the contraction of their norms.
double turns_to_enter(const SplitNorms& norms, const integrate::exact::tube::Parts& distance,
                      const integrate::exact::tube::Parts& radii);

}  // namespace rubsweep::response::proof
