#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::config {

/// Values and axis over keys that a line of cells takes from a configuration.
struct LineKeys {
  std::vector<sweep::KeyValue> fixed;  ///< keys that have one value in all cells of the line
  sweep::KeyAxis along;  ///< axis along which the line runs, with its values; empty keys: no such axis
  double factor = 1;     ///< factor of this axis for the key after which the line is named; not 0
};

/// Whether overrides name all keys of an axis. An override names a key if it writes the key or a map that
/// contains it.
bool are_named(const sweep::KeyAxis& axis, const std::vector<std::string>& overrides);

/// Splits the axes over keys of `grid`, the grid of the configuration in `file` under these overrides.
/// `along`: the key along which the line runs; empty for a single cell. If overrides name all keys of an
/// axis, the axis has the values of the overrides. An axis with one value keeps this value. For any other
/// axis the caller must choose a value: throws ConfigError with the places of all such axes. Keys in
/// `said_elsewhere` count as named.
LineKeys line_keys(const sweep::Grid& grid, std::string_view along, const std::filesystem::path& file,
                   const std::vector<std::string>& overrides,
                   const std::vector<std::string>& said_elsewhere = {});

/// Reads a configuration whose cells differ only by speed and unbalance. Values of axes over keys are written
/// into their keys, and these axes are removed. If overrides or `said_elsewhere` name all keys of an axis,
/// their values are used. Throws ConfigError as read_run_config does, and with the place of every other axis
/// of several values.
RunConfig read_cell_config(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& said_elsewhere = {});

/// Place of a key in a configuration that was read before: `file:line:column`, or `--set key=value` for an
/// override, or only the file where the key is not given. `path` is spelt as overrides are. Throws
/// ConfigError where the file is no longer a configuration.
std::string place_of_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                         std::string_view path);

/// Number at `path` in a complete configuration; `path` is spelt as overrides are (see override.hpp). Empty
/// where the path does not exist or holds no number.
std::optional<double> number_at(const RunConfig& config, std::string_view path);

}  // namespace rubsweep::config
