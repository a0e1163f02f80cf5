#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a table as instruments write them (table/layout.hpp). Text may stand before the table or beside its
/// first rows. Cells are separated by tabs, semicolons or commas, decimals by points or commas; comments
/// begin with '#' or '%'; line ends of any system, UTF-8, UTF-16 or Latin-1 are allowed. A unit stands behind
/// the name (in brackets, or behind a slash or a comma) or in a line of its own below the names; an ending
/// _s, _m, _um and the like of a name is also a unit. Columns without a name are "column 1", "column 2", ...
/// Columns of text are left out. A column of time stamps (table/time_stamp.hpp) becomes seconds since the
/// first one; stamps without a date may pass midnight. Signals may stand in rows, each behind its name. Words
/// instead of readings are gaps; lines of words are skipped, with a note. A sampling rate given above the
/// table is used. LabVIEW's .lvm is read with all its segments and clocks (labview_text.hpp). Throws
/// ConfigError with `name`:line:column for a cell that is no number, a row that is too short or too long, and
/// a text without numbers.
Channels read_delimited_text(std::string_view bytes, const std::string& name);

/// Reads one table of a text in UTF-8, which begins after `lines_before` lines of its file. Throws
/// table::Fault, with the line of the text.
Channels read_table(std::string_view text, std::size_t lines_before);

}  // namespace rubsweep::recording
