#pragma once

#include <functional>
#include <optional>

#include "rubsweep/branch/orbits/plane_orbits.hpp"
#include "rubsweep/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// The scene at each place of a plane of two parameters; empty where there is none.
using ScenePlane = std::function<std::optional<scene::Scene>(double first, double second)>;

/// Orbits of `order` turns of a plane of scenes, as scene_orbits() has them along a line. Ranges are left to
/// the caller.
PlaneOrbits scene_plane_orbits(ScenePlane plane, int order, const integrate::run::SolverOptions& solver,
                               integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
