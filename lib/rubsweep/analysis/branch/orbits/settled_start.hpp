#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

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
