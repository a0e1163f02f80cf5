#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/branch/orbit_problem.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::branch {

/// Where guards come nearest to what they guard and turn back: in flight the smallest gap between two hits,
/// in contact the smallest penetration, and so on for every guard that a mode has armed (contact::guards_of).
/// `samples`: states of the orbit at equal steps of the phase through its whole period (columns of 2n scaled
/// numbers, as TurnReport has them), the first one at the phase 0. `switches`: all of its changes of contact
/// mode. Maxima are those of cubics through the guard and its rate at two neighbouring samples between which
/// the contact does not change its mode. Of a scene with torsion none.
std::vector<Approach> approaches_of(const scene::Scene& scene, const Eigen::MatrixXd& samples,
                                    double period_rad, std::span<const integrate::run::ModeSwitch> switches);

}  // namespace rubsweep::branch
