#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config {

/// Interval in which a number of the rotor is known to lie.
struct KeyInterval {
  std::string key;                     ///< path such as "rotor.damping_ratio"
  double value = 0, from = 0, to = 0;  ///< from <= value <= to, from < to
};

/// Replaces every map {value, from, to} below `rotor` by its value and returns the intervals. Maps with these
/// keys that are no interval are problems.
std::vector<KeyInterval> take_intervals(yaml::Node& root, yaml::Diagnostics& diagnostics);

/// Intervals of a configuration, given as a text; `name` as in read_run_config_text. Throws ConfigError.
std::vector<KeyInterval> read_intervals(std::string_view text, const std::string& name);

}  // namespace rubsweep::config
