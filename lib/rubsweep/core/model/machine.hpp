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

/// Everything physical that does not change over a sweep. The first stop listed is the one kicked.
struct Machine {
  Rotor rotor;
  std::vector<Stop> stops;
  std::optional<Kick> kick;
  double gravity_m_per_s2 = 0;   ///< acceleration along -y, on rotor and moving casings; >= 0
  std::optional<Start> start{};  ///< excludes a kick
};

/// Its rotor kit; null where the rotor is of another kind.
inline const RotorKit* kit_of(const Machine& machine) { return std::get_if<RotorKit>(&machine.rotor); }
inline RotorKit* kit_of(Machine& machine) { return std::get_if<RotorKit>(&machine.rotor); }

/// Throws ConfigError naming the first number that is missing or out of range. The YAML reader reports the
/// same limits with their place in the file; this guards direct users of the library.
void validate(const Machine& machine);

}  // namespace rubsweep::model
