#pragma once

#include <string>

#include "rubsweep/model/machine.hpp"

namespace rubsweep::report {

/// What a run of `machine` simulates, what it leaves out and why, as text for a terminal.
/// `speed_hz` is the speed at which slip and friction saturation are stated, the lowest of a sweep.
std::string explain_machine(const model::Machine& machine, double speed_hz);

}  // namespace rubsweep::report
