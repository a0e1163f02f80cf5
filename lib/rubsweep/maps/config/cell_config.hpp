#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {

/// Configuration of cells that differ by speed and unbalance alone: the values of axes over keys are written
/// into their keys, and there are no such axes any more. An axis whose keys are all named by overrides or are
/// among those `said_elsewhere` has the values given there. Throws ConfigError as read_run_config does, and
/// with its place for every other axis of several values.
RunConfig read_cell_config(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& said_elsewhere = {});

}  // namespace rubsweep::config
