#pragma once

#include <memory>
#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::scene {

/// Structures of one machine at the speeds that were asked for.
class StructuresAtSpeeds;

/// Data common to all cells of one machine at any speed: never changed, so that threads may share it.
struct PreparedMachine {
  model::Machine machine;
  structure::Assembly assembly;
  std::optional<structure::Reduction> reduction;    ///< reduction of a rotor kit
  std::shared_ptr<StructuresAtSpeeds> at_speeds{};  ///< where supports follow tables: see prepared_at
};

/// Validates the machine, builds its structure and reduces it. Throws ConfigError, also where the numbers are
/// each allowed but too far apart for the structure to be computed.
PreparedMachine prepare_machine(const model::Machine& machine);

/// The machine at one speed, its supports as if their numbers there had been typed in: reduced by the modes
/// that it has at that speed. Kept for the next one that asks, from any thread. A machine without tables as
/// it is. Throws ConfigError where a table does not reach the speed, or the supports do not hold the shaft
/// there.
PreparedMachine prepared_at(const PreparedMachine& prepared, double speed_hz);

/// The same for a machine that differs from a prepared one in nothing but force, duration, direction and
/// phase of its kick, none of which the structure knows of.
PreparedMachine prepare_other_kick(const PreparedMachine& prepared, const model::Machine& machine);

/// A rotor kit as prepare_machine makes it, but reduced to so many modes at every speed, whatever it says
/// itself, and without the receptance error of its reduction, whose comparison takes most of the time. Throws
/// ConfigError as prepare_machine does.
PreparedMachine prepare_with_modes(const model::Machine& machine, int modes);

}  // namespace rubsweep::scene
