#pragma once

#include <memory>
#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/structure/assembly.hpp"
#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::scene {

/// Structures of one machine at single speeds, kept for reuse.
class StructuresAtSpeeds;

/// Data common to all cells of one machine at any speed. They never change, so that threads may share them.
struct PreparedMachine {
  model::Machine machine;
  structure::Assembly assembly;
  std::optional<structure::Reduction> reduction;    ///< reduction of a rotor kit
  std::shared_ptr<StructuresAtSpeeds> at_speeds{};  ///< for supports with tables: see prepared_at
};

/// Validates the machine, builds its structure and reduces it. Throws ConfigError, also where the numbers are
/// allowed one by one but too far apart for computing the structure.
PreparedMachine prepare_machine(const model::Machine& machine);

/// The machine at one speed, as if the coefficients of its supports at that speed had been entered as
/// constants, reduced to the modes that it has at this speed. The result is stored for the next call, from
/// any thread. A machine without tables is returned unchanged. Throws ConfigError where a table does not
/// reach the speed, or the supports do not hold the shaft there.
PreparedMachine prepared_at(const PreparedMachine& prepared, double speed_hz);

/// The prepared machine with another kick: `machine` differs only in force, duration, direction and phase of
/// its kick, which do not affect the structure.
PreparedMachine prepare_other_kick(const PreparedMachine& prepared, const model::Machine& machine);

/// A rotor kit prepared as by prepare_machine, but reduced to `modes` modes at every speed, whatever its own
/// setting. The receptance error of the reduction, which would take most of the time, is not computed. Throws
/// ConfigError as prepare_machine does.
PreparedMachine prepare_with_modes(const model::Machine& machine, int modes);

}  // namespace rubsweep::scene
