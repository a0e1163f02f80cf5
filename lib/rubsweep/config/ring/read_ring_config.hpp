#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/config/ring/ring_config.hpp"

namespace rubsweep::config::ring {

/// Reads a configuration of `ringstab`: ring, loads, friction_coefficient, preload_n (0), speed_rpm, chart
/// (optional), output. Problems, overrides and errors as in read_run_config.hpp. Speeds are sorted.
RingConfig read_ring_config(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// The same for a text; `name` stands for the file in messages. Throws ConfigError.
RingConfig read_ring_config_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides);

}  // namespace rubsweep::config::ring
