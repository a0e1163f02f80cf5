#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/casing.hpp"
#include "rubsweep/core/model/rotor.hpp"
#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::structure {

/// Jeffcott rotor and the moving ones among `casings` (one entry per stop). Coordinates: x and y of the
/// rotor, then x and y of every moving casing in the order of the stops; mass, damping and stiffness
/// diagonal, the circulatory matrix of rotating damping between x and y of the rotor. The unbalance turns
/// from +x towards +y: at t = 0 it points along +x.
Assembly assemble_jeffcott(const model::JeffcottRotor& rotor,
                           const std::vector<std::optional<model::Casing>>& casings);

}  // namespace rubsweep::structure
