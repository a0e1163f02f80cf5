#pragma once

#include <cstddef>
#include <string>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::report {

/// Lines about one stop for `--explain`: its geometry, force law, friction and casing. `cell` is of the speed
/// at which slip and friction saturation are stated.
std::string explain_stop(const scene::PreparedMachine& prepared, const scene::Cell& cell, std::size_t stop);

/// Explanation of a run of `machine` for a terminal: its model, the omissions and their reasons. `speed_hz`
/// is the speed at which slip and friction saturation are stated, the lowest of a sweep.
std::string explain_machine(const model::Machine& machine, double speed_hz);

}  // namespace rubsweep::report
