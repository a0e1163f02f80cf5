#pragma once

#include "support/one_side_equations.hpp"

namespace rubsweep::test {

struct PlainRun {
  OneSideState<double> state;  ///< after the last turn, m and m/s
  long rhs_calls = 0;
};

/// Unit of all speed ratios: Odeint's controlled Dormand-Prince method with the clamped law and without event
/// location. The absolute tolerance is 1e-3 of the relative one, because states are in metres. Do not improve
/// it.
PlainRun run_plain_dopri5(const OneSideRotor& rotor, int turns, double relative_tolerance);

}  // namespace rubsweep::test
