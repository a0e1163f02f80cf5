#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// Closed orbits of a family of rotationally symmetric scenes in the frame that turns with the shaft, their
/// pulses left out: seen from outside, ovals. Their period is not known beforehand, and every shift along
/// such an orbit is one as well. So a state is where the observed point is farthest from the axis, 2n scaled
/// numbers in the turning frame, and behind them the time of one loop in turns of the shaft: its image is the
/// state at the maximum nearest to that time, and the time that it took. Orbits are fixed points, their
/// multipliers those of the orbit without the trivial one, and two zeros, which stand for the shift and for
/// the time. `loops`: of the period that is looked for, so that 2 stands for orbits of twice the period; the
/// time is then the mean of the loops. An oval of one loop may itself come to be one of half its time, where
/// the maximum half a loop on becomes the same: its facts have that maximum as a second section. A scene that
/// is not rotationally symmetric is infeasible. Range and scale of the parameter are left to the caller. The
/// solver works at 1e-11.
OrbitProblem oval_orbits(SceneFamily family, int loops, const integrate::run::SolverOptions& solver);

/// The state with which `orbit_from` finds the oval through `point` (2n scaled numbers in the turning frame)
/// that closes after `period_rad` of shaft rotation: the point of it that is farthest from the axis, and its
/// time. Empty where the solver cannot follow it.
std::optional<Eigen::VectorXd> oval_state(const scene::Scene& scene,
                                          const integrate::run::SolverOptions& solver,
                                          const Eigen::VectorXd& point, double period_rad);

}  // namespace rubsweep::branch::orbits
