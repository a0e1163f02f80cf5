#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::branch::orbits {

/// Scene at each value of a parameter; empty where it does not exist.
using SceneFamily = std::function<std::optional<scene::Scene>(double parameter)>;

/// Orbits of `order` turns of a family of scenes without their pulses. States are sections, scaled by the
/// length scale and the speed of their scene. The caller sets range and scale of the parameter. A solver with
/// a tolerance uses 1e-11. `modes` must outlive the problem, which belongs to one thread. Throws ConfigError
/// for a scene whose impulses differ from turn to turn.
OrbitProblem scene_orbits(SceneFamily family, int order, const integrate::run::SolverOptions& solver,
                          integrate::exact::modes::ModeCache& modes);

/// Frame in which an orbit closes.
enum class Closing {
  with_the_shaft,        ///< after whole turns: fixed point of the section map
  in_the_turning_frame,  ///< an oval: in the rotating frame, with a period that need not be whole turns
};

constexpr std::string_view to_string(Closing closing) { return enumerator_word(closing); }

/// Makes scene_orbits() or oval_orbits(), with `order` as the number of turns or of loops.
OrbitProblem closed_orbits(Closing closing, SceneFamily family, int order,
                           const integrate::run::SolverOptions& solver,
                           integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
