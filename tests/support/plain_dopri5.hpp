#pragma once

#include "support/one_side_equations.hpp"

namespace rubsweep::test {

struct PlainRun {
  OneSideState<double> state;  ///< after the last turn, m and m/s
  long rhs_calls = 0;
};

/// The unit of every speed ratio: Odeint's controlled Dormand-Prince straight through the clamped law, no
/// event location, absolute tolerance 1e-3 of the relative one since states are in metres. Frozen: do not
/// improve it.
PlainRun run_plain_dopri5(const OneSideRotor& rotor, int turns, double relative_tolerance);

}  // namespace rubsweep::test
