#pragma once

#include <vector>

#include "support/one_side_equations.hpp"

namespace rubsweep::test {

/// Section states after 0, 1, 2, ..., `turns` revolutions from an independent, slow and simple method: small
/// fixed steps of Runge-Kutta-Fehlberg 7(8) in long double. Each piece of the force law is integrated
/// separately; bisection over the step length locates changes of piece and the end of the kick.
std::vector<OneSideState<long double>> long_double_sections(const OneSideRotor& rotor, int turns,
                                                            int steps_per_turn = 2000);

}  // namespace rubsweep::test
