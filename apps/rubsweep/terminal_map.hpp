#pragma once

#include <filesystem>
#include <string>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// Text about a finished map, if standard output is a terminal; else empty.
struct TerminalView {
  std::string map;   ///< map as characters; empty where an axis is not in order
  std::string next;  ///< commands for a closer look: rubtrace for the most frequent rub, and the report
};

/// Width of the terminal at standard output: 80 where there is none, at most 110.
std::size_t terminal_width();

/// Whether colours are used: only on a terminal with 24-bit colours, and not if NO_COLOR is set
/// (https://no-color.org).
bool shows_colours();

/// Reads the map with this grid at `path` as characters; empty where it cannot be shown. Throws IoError.
std::string map_in_characters(const std::filesystem::path& path, const sweep::Grid& grid);

/// Reads the map with this grid at `path`. Throws IoError.
TerminalView terminal_view(const std::filesystem::path& path, const sweep::Grid& grid, bool has_report);

}  // namespace rubsweep::apps
