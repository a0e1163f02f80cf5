#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/config/run_config.hpp"

namespace rubsweep::config {

/// The number that a complete configuration has at `path`, spelt as overrides are (see override.hpp). Empty
/// where there is nothing there or no number.
std::optional<double> number_at(const RunConfig& config, std::string_view path);

}  // namespace rubsweep::config
