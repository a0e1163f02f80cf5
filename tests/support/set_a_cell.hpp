#pragma once

#include "rubsweep/core/scene/build_scene.hpp"
#include "support/one_side_equations.hpp"

namespace rubsweep::test {

/// The machine that `OneSideEquations` writes out by hand, as the library takes it.
model::Machine machine_of(const OneSideRotor& rotor);

/// Its cell at the rotor's speed and whirl ratio.
scene::Cell cell_of(const OneSideRotor& rotor);

/// Largest difference of a scaled section from a reference state in SI units, both scaled by (clearance,
/// clearance * omega).
double section_error(const std::vector<double>& section, const OneSideState<long double>& reference,
                     const OneSideRotor& rotor);

}  // namespace rubsweep::test
