#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "rubsweep/core/model/kick.hpp"
#include "rubsweep/core/model/rotor.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/start.hpp"
#include "rubsweep/core/model/stop.hpp"

namespace rubsweep::model {

/// A rotor of either kind.
using Rotor = std::variant<JeffcottRotor, RotorKit>;

/// All physical data that stay the same over a sweep. The kick acts at the first stop listed.
struct Machine {
  Rotor rotor;
  std::vector<Stop> stops;
  std::optional<Kick> kick;
  double gravity_m_per_s2 = 0;   ///< acceleration along -y of rotor and moving casings; >= 0
  std::optional<Start> start{};  ///< start state; excludes a kick
};

/// Rotor kit of the machine; null for another kind of rotor.
inline const RotorKit* kit_of(const Machine& machine) { return std::get_if<RotorKit>(&machine.rotor); }
inline RotorKit* kit_of(Machine& machine) { return std::get_if<RotorKit>(&machine.rotor); }

/// Throws ConfigError naming the first number that is missing or out of range. The YAML reader reports the
/// same limits with their place in the file; this check is for programs that use the library directly.
void validate(const Machine& machine);

}  // namespace rubsweep::model
