#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/response/motion/motion_class.hpp"
#include "rubsweep/response/motion/options.hpp"
#include "rubsweep/response/motion/workspace.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::branch {

/// What a cell settles on when it is run from its kick.
struct SettledStart {
  response::motion::MotionClass motion_class = response::motion::MotionClass::failed;
  std::optional<int> order;  ///< of a periodic motion in contact; empty: there is no orbit to follow
  Eigen::VectorXd section;   ///< scaled, near the orbit
};

/// Runs the cell until its motion is known. `cell` can run.
SettledStart settle_on_orbit(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                             const response::motion::ResponseOptions& options,
                             response::motion::Workspace& workspace);

}  // namespace rubsweep::branch
