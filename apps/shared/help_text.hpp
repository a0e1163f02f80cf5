#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rubsweep::apps {

/// Columns of a terminal that --help fits into.
inline constexpr std::size_t help_columns = 100;

/// The text with no line longer than `columns` as far as its words allow. A paragraph with a longer line is
/// filled anew: lines that begin at one column, or a row of a table ("  name  meaning") with the lines below
/// its meaning. Below "Examples:" lines are commands, which go on behind a backslash. Nothing else changes.
std::string wrapped(std::string_view text, std::size_t columns = help_columns);

}  // namespace rubsweep::apps
