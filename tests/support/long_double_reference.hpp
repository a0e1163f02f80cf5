#pragma once

#include <vector>

#include "support/one_side_equations.hpp"

namespace rubsweep::test {

/// Section states (after 1, 2, ..., `turns` revolutions; index 0 is the start) by another route, slow and
/// readable: fixed small steps of Runge-Kutta-Fehlberg 7(8) in long double, each piece of the force law on
/// its own, piece changes and the end of the kick met by bisection on the length of the step.
std::vector<OneSideState<long double>> long_double_sections(const OneSideRotor& rotor, int turns,
                                                            int steps_per_turn = 2000);

}  // namespace rubsweep::test
