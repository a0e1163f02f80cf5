#pragma once

#include <Eigen/Core>
#include <optional>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// Closed orbits, in the frame that rotates with the shaft, of a family of rotationally symmetric scenes
/// without their pulses. In the fixed frame they are ovals. The period of such an orbit is unknown, and every
/// shift along the orbit is again a solution. A state is therefore taken where the observed point is farthest
/// from the axis: 2n scaled numbers in the rotating frame, followed by the time of one loop in turns of the
/// shaft. The map takes a state to the maximum of the distance nearest to that time, and replaces the time by
/// the actual one. Orbits are fixed points of this map. Its multipliers are those of the orbit without the
/// trivial multiplier, and two zeros for the shift and the time. `loops`: number of loops in the period, such
/// as 2 for orbits of twice the period; the time is then the mean of the loops. The two halves of a single
/// loop may become equal along a branch. To detect this, the facts contain the maximum half a loop later as a
/// second section. Scenes without rotational symmetry are infeasible. The caller sets range and scale of the
/// parameter. The solver's tolerance is 1e-11.
OrbitProblem oval_orbits(SceneFamily family, int loops, const integrate::run::SolverOptions& solver);

/// Start state from which `orbit_from` finds the oval through `point` (2n scaled numbers in the rotating
/// frame). The oval has the period `period_rad` of shaft rotation. The result is its point farthest from the
/// axis, followed by its time. Empty where the solver cannot follow the oval.
std::optional<Eigen::VectorXd> oval_state(const scene::Scene& scene,
                                          const integrate::run::SolverOptions& solver,
                                          const Eigen::VectorXd& point, double period_rad);

}  // namespace rubsweep::branch::orbits
