#pragma once

#include <vector>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::audit {

/// Section (as integrate::run::TurnReport::section) one revolution after `section`, by the classical
/// Runge-Kutta method of order 4 in `steps` equal steps straight through the force law: no event is located,
/// none is needed, and no code of the solvers is used. The error is of the square of a step at every change
/// of contact mode. `scene` without a pulse.
std::vector<double> fixed_step_turn(const scene::Scene& scene, const std::vector<double>& section, int steps);

}  // namespace rubsweep::audit
