#pragma once

#include <string>

#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::report {

/// What to lower where `modes: auto` keeps so many modes of a rotor kit that cells are slow by them, in one
/// line without its end; empty where it does not.
std::string describe_many_modes(const scene::PreparedMachine& prepared);

}  // namespace rubsweep::report
