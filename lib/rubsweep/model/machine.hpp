#pragma once

#include <optional>
#include <vector>

#include "rubsweep/model/kick.hpp"
#include "rubsweep/model/rotor.hpp"
#include "rubsweep/model/rotor_kit.hpp"
#include "rubsweep/model/stop.hpp"

namespace rubsweep::model {

/// Everything physical that does not change over a sweep. The first stop listed is the one kicked.
struct Machine {
  JeffcottRotor rotor;
  std::vector<Stop> stops;
  std::optional<Kick> kick;
  double gravity_m_per_s2 = 0;                 ///< acceleration along -y, on rotor and moving casings; >= 0
  std::optional<RotorKit> kit = std::nullopt;  ///< a beam rotor that takes the place of `rotor`
};

/// Throws ConfigError naming the first number that is missing or out of range. The YAML reader reports the
/// same limits with their place in the file; this guards direct users of the library.
void validate(const Machine& machine);

}  // namespace rubsweep::model
