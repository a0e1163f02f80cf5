#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/response/motion/options.hpp"
#include "rubsweep/response/motion/workspace.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// The oval that a rotationally symmetric scene settles on from `section` (scaled, at the start of a turn,
/// which is a state of the turning frame as well), its pulses left out: a state of `oval_orbits`. Empty where
/// it settles on no closed orbit of the turning frame within `options.max_revolutions` turns.
std::optional<Eigen::VectorXd> oval_from(const scene::Scene& scene, const Eigen::VectorXd& section,
                                         const integrate::run::SolverOptions& solver,
                                         const response::motion::ResponseOptions& options,
                                         response::motion::Workspace& workspace);

}  // namespace rubsweep::branch::orbits
