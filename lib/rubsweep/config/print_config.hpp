#pragma once

#include <string>

#include "rubsweep/config/run_config.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::config {

/// The complete configuration as YAML, defaults included, that reads back as an equal one. Equal
/// configurations give equal bytes. What is optional and has no value of its own (kick, kick.angle_deg,
/// contact_mass_kg) is left out. Throws ConfigError when the output directory is not UTF-8.
std::string print_config(const RunConfig& config);

/// The same without `output`: everything that decides the numbers of a map, nothing else.
std::string print_study(const sweep::Study& study);

}  // namespace rubsweep::config
