#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::config {

/// Split of a configuration's axes over keys for a line of cells.
struct LineKeys {
  std::vector<sweep::KeyValue> fixed;  ///< values on every cell of the line
  sweep::KeyAxis along;  ///< the axis that the line runs along, with its values; no keys: it runs along none
  double factor = 1;     ///< factor of that axis for the key that names the line, not 0
};

/// Whether all keys of an axis are named by an override, which writes the key itself or a map around it.
bool are_named(const sweep::KeyAxis& axis, const std::vector<std::string>& overrides);

/// `along` is the key that the line runs along, empty for a single cell. The keys of an axis that are all
/// named by an override hold what that says; an axis with one value holds it. Throws ConfigError with the
/// places of all other axes: which of their values is meant must be said. `grid` is that of the configuration
/// in `file` under these overrides; keys that are `said_elsewhere` count as named.
LineKeys line_keys(const sweep::Grid& grid, std::string_view along, const std::filesystem::path& file,
                   const std::vector<std::string>& overrides,
                   const std::vector<std::string>& said_elsewhere = {});

/// Configuration of cells that differ by speed and unbalance alone: the values of axes over keys are written
/// into their keys, and there are no such axes any more. An axis whose keys are all named by overrides or are
/// among those `said_elsewhere` has the values given there. Throws ConfigError as read_run_config does, and
/// with its place for every other axis of several values.
RunConfig read_cell_config(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& said_elsewhere = {});

/// Place of a key of a configuration that was read before, as problems name it: `file:line:column`, or `--set
/// key=value` of an override. The file alone where the key is not given. `path` is spelt as overrides are.
/// Throws ConfigError where the file is none any more.
std::string place_of_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                         std::string_view path);

/// The number that a complete configuration has at `path`, spelt as overrides are (see override.hpp). Empty
/// where there is nothing there or no number.
std::optional<double> number_at(const RunConfig& config, std::string_view path);

}  // namespace rubsweep::config
