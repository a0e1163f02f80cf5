#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rubsweep::apps {

/// Width of a terminal that --help fits into, in characters.
inline constexpr std::size_t help_columns = 100;

/// The text with its lines broken at `columns`, as far as its words allow. Only paragraphs with a longer line
/// are refilled. A paragraph is a number of lines with the same indentation, or a table row ("  name
/// meaning") with the lines below its meaning. Below "Examples:" lines are commands, which are continued
/// after a backslash.
std::string wrapped(std::string_view text, std::size_t columns = help_columns);

}  // namespace rubsweep::apps
