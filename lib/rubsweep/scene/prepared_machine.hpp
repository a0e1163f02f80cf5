#pragma once

#include <optional>

#include "rubsweep/model/machine.hpp"
#include "rubsweep/structure/assembly.hpp"
#include "rubsweep/structure/reduction.hpp"

namespace rubsweep::scene {

/// Data common to all cells of one machine at any speed: never changed, so that threads may share it.
struct PreparedMachine {
  model::Machine machine;
  structure::Assembly assembly;
  std::optional<structure::Reduction> reduction;  ///< of a rotor kit
};

/// Validates the machine, builds its structure and reduces it. Throws ConfigError, also where the numbers are
/// each allowed but too far apart for the structure to be computed.
PreparedMachine prepare_machine(const model::Machine& machine);

/// The same for a machine that differs from a prepared one in nothing but force, duration, direction and
/// phase of its kick, none of which the structure knows of.
PreparedMachine prepare_other_kick(const PreparedMachine& prepared, const model::Machine& machine);

}  // namespace rubsweep::scene
