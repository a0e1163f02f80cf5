#pragma once

#include <string>
#include <string_view>

#include "rubsweep/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a table as instruments write them: text before it (names and units are the last lines of that which
/// have as many cells as the numbers; without them the names are "column 1", "column 2", ...), cells parted
/// by tabs, semicolons or commas, decimal points or commas, comments behind
/// '#' or '%', byte order mark, line ends of any system. A unit stands in brackets behind the name or in a
/// line of its own below the names; names that end with _s or _m are in seconds or metres. A first column of
/// time stamps (12:30:01.25, with or without a date before it) becomes seconds since the first one; it may
/// pass midnight where it has no date. Throws ConfigError with `name`:line:column for a cell that is no
/// number, a row that is too short or too long, and a text without numbers.
Channels read_delimited_text(std::string_view text, const std::string& name);

}  // namespace rubsweep::recording
