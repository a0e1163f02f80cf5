#pragma once

#include <vector>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::audit {

/// Section (like integrate::run::TurnReport::section) one revolution after `section`, by the classical
/// fourth-order Runge-Kutta method in `steps` equal steps through the force law. It locates no events and
/// uses no code of the solvers. Each change of contact mode causes an error of the order of the step squared.
/// `scene` must have no pulse.
std::vector<double> fixed_step_turn(const scene::Scene& scene, const std::vector<double>& section, int steps);

}  // namespace rubsweep::audit
