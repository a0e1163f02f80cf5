#pragma once

#include <filesystem>
#include <string>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// View of a finished map where standard output is a terminal; empty texts where it is not.
struct TerminalView {
  std::string map;   ///< map in characters; empty where the values of an axis are in no order
  std::string next;  ///< commands that look closer: the most frequent rub by rubtrace, the report
};

/// Columns of the terminal behind standard output, 80 where there is none, at most 110.
std::size_t terminal_width();

/// Whether colours are used: as https://no-color.org has it, and only on a terminal with 24-bit colours.
bool shows_colours();

/// Reads the map at `path`, whose grid this is; empty where it cannot be shown. Throws IoError.
std::string map_in_characters(const std::filesystem::path& path, const sweep::Grid& grid);

/// Reads the map at `path`, whose grid this is. Throws IoError.
TerminalView terminal_view(const std::filesystem::path& path, const sweep::Grid& grid, bool has_report);

}  // namespace rubsweep::apps
