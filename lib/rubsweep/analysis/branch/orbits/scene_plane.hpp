#pragma once

#include <functional>
#include <optional>

#include "rubsweep/analysis/branch/orbits/plane_orbits.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// The scene at each place of a plane of two parameters; empty where there is none.
using ScenePlane = std::function<std::optional<scene::Scene>(double first, double second)>;

/// Orbits of `order` turns of a plane of scenes, as scene_orbits() has them along a line. Ranges are left to
/// the caller.
PlaneOrbits scene_plane_orbits(ScenePlane plane, int order, const integrate::run::SolverOptions& solver,
                               integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
