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

/// The scene at each value of a parameter; empty where there is none.
using SceneFamily = std::function<std::optional<scene::Scene>(double parameter)>;

/// Orbits of `order` turns of a family of scenes, their pulses left out: the states are sections, scaled by
/// the length scale and the speed of the scene that they belong to. Range and scale of the parameter are left
/// to the caller. The solver works at 1e-11 where it has a tolerance. `modes` must outlive the problem, which
/// belongs to one thread. Throws ConfigError at a scene whose impulses are not the same in every turn.
OrbitProblem scene_orbits(SceneFamily family, int order, const integrate::run::SolverOptions& solver,
                          integrate::exact::modes::ModeCache& modes);

/// How an orbit closes.
enum class Closing {
  with_the_shaft,        ///< after whole turns: a fixed point of the section map
  in_the_turning_frame,  ///< an oval: in the frame that turns with the shaft, after a time of its own
};

constexpr std::string_view to_string(Closing closing) { return enumerator_word(closing); }

/// scene_orbits() or oval_orbits(), whose `order` is that of turns or of loops.
OrbitProblem closed_orbits(Closing closing, SceneFamily family, int order,
                           const integrate::run::SolverOptions& solver,
                           integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
