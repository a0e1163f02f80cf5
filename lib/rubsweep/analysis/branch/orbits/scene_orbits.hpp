#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
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

/// Oval on which a rotationally symmetric scene settles without its pulses, as a state for `oval_orbits`.
/// `section` is the scaled state at the start of a turn, where fixed and rotating frame coincide. Empty where
/// the scene reaches no closed orbit of the rotating frame within `options.max_revolutions` turns.
std::optional<Eigen::VectorXd> oval_from(const scene::Scene& scene, const Eigen::VectorXd& section,
                                         const integrate::run::SolverOptions& solver,
                                         const response::motion::ResponseOptions& options,
                                         response::motion::Workspace& workspace);

/// Motion on which a cell settles when it is run from its kick.
struct SettledStart {
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order;  ///< order of the closed orbit with contact; empty: no orbit to follow
  Closing closing = Closing::with_the_shaft;
  Eigen::VectorXd state;  ///< state near the orbit, as defined by closed_orbits()
};

/// Runs the cell, which must be able to run, until its motion is known: a periodic motion, or an oval of a
/// rotationally symmetric scene.
SettledStart settle_on_orbit(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                             const response::motion::ResponseOptions& options,
                             response::motion::Workspace& workspace);

}  // namespace rubsweep::branch::orbits
