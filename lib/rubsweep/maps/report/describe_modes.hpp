#pragma once

#include <string>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::report {

/// Advice on the key to lower where `modes: auto` keeps so many modes of a rotor kit that cells become slow,
/// one line without its end; empty where it does not.
std::string describe_many_modes(const scene::PreparedMachine& prepared);

}  // namespace rubsweep::report
