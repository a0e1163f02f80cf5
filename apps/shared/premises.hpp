#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Warns on the standard error where a premise of the study does not hold, before anything is run: a rotor
/// that is unstable without its stops. `prepared` is that of study.machine.
void warn_of_premises(std::string_view program, const sweep::Study& study,
                      const scene::PreparedMachine& prepared);

/// The same at these speeds alone, whatever the grid of the study.
void warn_of_premises_at(std::string_view program, const std::vector<double>& speeds_hz, sweep::Study study,
                         const scene::PreparedMachine& prepared);

}  // namespace rubsweep::apps
