#pragma once

#include "rubsweep/model/machine.hpp"
#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::fit {

/// The machine of a fit at one step, as scene::prepare_machine makes it, but a rotor kit is reduced to as
/// many modes as `first`, the machine at which the fit began: a number that jumps has no derivative. Throws
/// ConfigError as prepare_machine does.
scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first);

}  // namespace rubsweep::fit
