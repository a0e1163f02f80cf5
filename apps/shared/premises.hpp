#pragma once

#include <string_view>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Warns on standard error, before anything is run, where the study's assumption of a rotor that is stable
/// without stops fails. `prepared` belongs to study.machine.
void warn_of_premises(std::string_view program, const sweep::Study& study,
                      const scene::PreparedMachine& prepared);

/// Warns at these speeds only, whatever the grid of the study is.
void warn_of_premises_at(std::string_view program, const std::vector<double>& speeds_hz, sweep::Study study,
                         const scene::PreparedMachine& prepared);

}  // namespace rubsweep::apps
