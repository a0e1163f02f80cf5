#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::apps {

/// Lines for `--explain` on one stop: geometry, force law, friction and casing. Slip and saturation of
/// friction are stated at the speed of `cell`.
std::string explain_stop(const scene::PreparedMachine& prepared, const scene::Cell& cell, std::size_t stop,
                         const std::string& name = {});

/// Explanation of `machine` for a terminal: the model, its omissions and their reasons. Slip and saturation
/// of friction are stated at `speed_hz`, the lowest speed of a sweep.
std::string explain_machine(const model::Machine& machine, double speed_hz,
                            const std::vector<std::string>& stop_names = {});

}  // namespace rubsweep::apps
