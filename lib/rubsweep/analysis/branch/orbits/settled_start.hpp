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

/// The oval that a rotationally symmetric scene settles on from `section` (scaled, at the start of a turn,
/// which is a state of the turning frame as well), its pulses left out: a state of `oval_orbits`. Empty where
/// it settles on no closed orbit of the turning frame within `options.max_revolutions` turns.
std::optional<Eigen::VectorXd> oval_from(const scene::Scene& scene, const Eigen::VectorXd& section,
                                         const integrate::run::SolverOptions& solver,
                                         const response::motion::ResponseOptions& options,
                                         response::motion::Workspace& workspace);

/// Motion that a cell settles on when it is run from its kick.
struct SettledStart {
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order;  ///< order of the closed orbit, in contact; empty: there is none to follow
  Closing closing = Closing::with_the_shaft;
  Eigen::VectorXd state;  ///< near the orbit, as its closed_orbits() have it
};

/// Runs the cell until its motion is known: a periodic one, or an oval of a rotationally symmetric scene.
/// `cell` can run.
SettledStart settle_on_orbit(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                             const response::motion::ResponseOptions& options,
                             response::motion::Workspace& workspace);

}  // namespace rubsweep::branch::orbits
