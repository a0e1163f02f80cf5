#pragma once

#include <string>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::report {

/// Explanation of `machine` for a terminal: the model, and what it leaves out and why. Slip and saturation of
/// friction are stated at `speed_hz`, the lowest speed of a sweep.
std::string explain_machine(const model::Machine& machine, double speed_hz);

}  // namespace rubsweep::report
