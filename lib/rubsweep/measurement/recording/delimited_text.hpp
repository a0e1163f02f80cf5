#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a table as instruments write them (table/layout.hpp): text before it or beside its first rows, cells
/// parted by tabs, semicolons or commas, decimal points or commas, comments behind '#' or '%', line ends of
/// any system, UTF-8, UTF-16 or Latin-1. A unit stands in brackets behind the name, behind a stroke or a
/// comma, or in a line of its own below the names; names that end with _s, _m, _um and the like say it
/// themselves; columns without a name are "column 1", "column 2", ... Columns of text are left out. A column
/// of time stamps (table/time_stamp.hpp) becomes seconds since the first one; it may pass midnight where it
/// has no date. Signals may lie in rows, each behind its name. Words in the place of readings are gaps, lines
/// of words are passed over and told. A sampling rate that the head
/// says is taken. LabVIEW's .lvm is read with all its segments and clocks (labview_text.hpp). Throws
/// ConfigError with `name`:line:column for a cell that is no number, a row that is too short or too long, and
/// a text without numbers.
Channels read_delimited_text(std::string_view bytes, const std::string& name);

/// Reads one table of a text in UTF-8 that begins behind so many lines of its file. Throws table::Fault, with
/// the line of the text.
Channels read_table(std::string_view text, std::size_t lines_before);

}  // namespace rubsweep::recording
