#pragma once

#include "rubsweep/core/scene/build_scene.hpp"
#include "support/one_side_equations.hpp"

namespace rubsweep::test {

/// The machine of `OneSideEquations` as a machine of the library.
model::Machine machine_of(const OneSideRotor& rotor);

/// The cell of this machine at the rotor's speed and whirl ratio.
scene::Cell cell_of(const OneSideRotor& rotor);

/// Largest difference between a scaled section and a reference state in SI units, in units of (clearance,
/// clearance * omega).
double section_error(const std::vector<double>& section, const OneSideState<long double>& reference,
                     const OneSideRotor& rotor);

}  // namespace rubsweep::test
