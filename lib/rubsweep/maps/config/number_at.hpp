#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {

/// Place of a key of a configuration that was read before, as problems name it: `file:line:column`, or `--set
/// key=value` of an override. The file alone where the key is not given. `path` is spelt as overrides are.
/// Throws ConfigError where the file is none any more.
std::string place_of_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                         std::string_view path);

/// The number that a complete configuration has at `path`, spelt as overrides are (see override.hpp). Empty
/// where there is nothing there or no number.
std::optional<double> number_at(const RunConfig& config, std::string_view path);

}  // namespace rubsweep::config
