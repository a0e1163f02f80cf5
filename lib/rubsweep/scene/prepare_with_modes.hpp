#pragma once

#include "rubsweep/model/machine.hpp"
#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::scene {

/// A rotor kit as prepare_machine makes it, but reduced to so many modes at every speed, whatever it says
/// itself, and without the receptance error of its reduction, whose comparison takes most of the time. Throws
/// ConfigError as prepare_machine does.
PreparedMachine prepare_with_modes(const model::Machine& machine, int modes);

}  // namespace rubsweep::scene
