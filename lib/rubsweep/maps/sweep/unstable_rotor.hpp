#pragma once

#include <string>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Word in the status of a row whose rotor is unstable without its stops
/// (response::proof::RestProof::vibration_grows).
inline constexpr const char* unstable_rotor = "unstable_rotor";

/// Where the premise of a quiet motion fails, one line for people: at which speeds of the study a free
/// vibration of the rotor without its stops grows (structure::grows), as by cross-coupled bearings or damping
/// that turns with the shaft. Empty where none does. At most 400 speeds are looked at, and 16 of the machines
/// that axes over keys make, spread evenly. `prepared` is that of study.machine.
/// Throws ConfigError where the full matrices of a kit say otherwise at the first, a middle and the last
/// speed, or where the growth is fastest.
std::string where_rotor_is_unstable(const Study& study, const scene::PreparedMachine& prepared);

}  // namespace rubsweep::sweep
