#pragma once

#include <string>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::report {

/// Explanation of a run of `machine` for a terminal: its model, the omissions and their reasons. `speed_hz`
/// is the speed at which slip and friction saturation are stated, the lowest of a sweep.
std::string explain_machine(const model::Machine& machine, double speed_hz);

}  // namespace rubsweep::report
