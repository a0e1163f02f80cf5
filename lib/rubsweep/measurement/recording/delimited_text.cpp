#include "rubsweep/measurement/recording/delimited_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/table/head.hpp"
#include "rubsweep/maps/table/rows.hpp"
#include "rubsweep/measurement/recording/labview_text.hpp"

namespace rubsweep::recording {
namespace {

using table::Fault;

constexpr std::size_t most_text_numbers = std::size_t{1} << 28;  ///< Most numbers of one text.

/// Converts stamps to seconds since the first one. Stamps without a date restart at midnight; a day is then
/// added.
void count_from_first(std::vector<double>& stamps_s) {
  constexpr double day_s = 86400;
  const double first_s = stamps_s.front();
  double midnights = 0, before_s = 0;
  for (double& t_s : stamps_s) {
    t_s -= first_s;
    if (t_s + midnights * day_s < before_s - day_s / 2) ++midnights;
    t_s += midnights * day_s;
    before_s = t_s;
  }
}

/// Unit at the end of a name: any unit behind a comma or slash, usual units also behind a blank or
/// underscore, and x_m_per_s2 as m/s2.
std::string unit_in_name(std::string_view name) {
  if (const std::size_t per = name.rfind("_per_"); per != std::string_view::npos && per > 0) {
    const std::size_t begin = name.rfind('_', per - 1) + 1;  // 0 without an underscore
    const std::string unit = fmt::format("{}/{}", name.substr(begin, per - begin), name.substr(per + 5));
    if (table::is_unit(unit)) return unit;
  }
  if (std::string unit = unit_in_ending(name); !unit.empty()) return unit;
  constexpr std::array<std::string_view, 19> usual{
      "s",   "ms",   "us",   "sec",  "mm",    "um",    "mil",   "mv",      "hz",   "rpm",
      "m/s", "mm/s", "m/s2", "mils", "u/min", "1/min", "rad/s", "rev/min", "r/min"};
  const auto tail_behind = [&](std::string_view marks) -> std::string_view {
    const std::size_t mark = name.find_last_of(marks);
    if (mark == std::string_view::npos || mark == 0) return {};
    return name.substr(mark + 1);
  };
  if (const std::string_view tail = tail_behind(" _"); !tail.empty()) {
    const bool listed =
        std::ranges::find(usual, table::in_small_letters(table::plain_unit(tail))) != usual.end();
    const std::string_view before = name.substr(0, name.size() - tail.size() - 1);
    if (listed || (before.ends_with(',') && table::is_unit(tail))) return std::string(tail);
  }
  const std::string_view tail = tail_behind("/,");
  return !tail.empty() && tail != "-" && table::is_unit(tail) ? std::string(tail) : std::string();
}

/// Adds an empty channel for each column of numbers; returns the positions of these columns.
std::vector<std::size_t> begin_channels(const table::Layout& layout, std::size_t lines_before,
                                        Channels& table) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const table::Column& column = layout.columns[i];
    std::string name = column.heading.name.empty() ? "column " + std::to_string(i + 1) : column.heading.name;
    if (column.is_text) {
      table.left_out.push_back(
          {name, column.text_line > 0
                     ? "holds text, as in line " + std::to_string(lines_before + column.text_line)
                     : "holds text"});
      continue;
    }
    places.push_back(i);
    std::string unit = column.is_stamp               ? "s"
                       : column.heading.unit.empty() ? unit_in_name(name)
                                                     : column.heading.unit;
    table.channels.push_back({std::move(name), std::move(unit), {}, i + 1});
  }
  return places;
}

void leave_out_empty(Channels& table) {
  if (std::ranges::all_of(table.channels, [](const Channel& channel) { return channel.is_empty(); })) return;
  std::erase_if(table.channels, [&](const Channel& channel) {
    if (channel.is_empty()) table.left_out.push_back({channel.name, "is empty"});
    return channel.is_empty();
  });
}

void tell_notes(const table::Rows& rows, std::size_t lines_before, Channels& table) {
  if (rows.notes().empty()) return;
  const std::size_t others = rows.notes().size() - 1;
  table.notes.push_back(fmt::format("line {} holds words and no numbers and is passed over{}",
                                    lines_before + rows.notes().front(),
                                    others > 0 ? fmt::format(", as are {} others", others) : ""));
}

/// Whether signals stand in rows instead of columns: few long lines, without a line of names above them.
bool lies_in_rows(std::string_view text, const table::Layout& layout) {
  constexpr std::size_t fewest = 16, longer = 4;
  if (layout.names_line > 0 || layout.columns.size() < fewest) return false;
  text.remove_prefix(layout.numbers_offset);
  for (std::size_t lines = 0; !text.empty(); lines += !table::is_comment(table::take_line(text)))
    if (longer * lines > layout.columns.size()) return false;
  return true;
}

Channels read_rows_as_signals(std::string_view text, const table::Layout& layout) {
  table::Rows rows(text, layout);
  Channels table;
  table.sampling_rate_hz = table::sampling_rate_in(text, layout);
  const bool named = layout.columns.front().is_text;
  while (rows.next()) {
    table::Heading heading;
    if (named) heading = table::heading_of(rows.cells().front());
    if (heading.name.empty()) heading.name = "row " + std::to_string(table.channels.size() + 1);
    if (heading.unit.empty()) heading.unit = unit_in_name(heading.name);
    table.channels.push_back({heading.name, heading.unit, {}, table.channels.size() + 1});
    for (std::size_t i = named ? 1 : 0; i < layout.columns.size(); ++i)
      table.channels.back().values.push_back(i < rows.cells().size() ? rows.reading(i) : NAN);
  }
  return table;
}

}  // namespace

Channels read_table(std::string_view text, std::size_t lines_before) {
  const table::Layout layout = table::layout_of(text);
  if (lies_in_rows(text, layout)) return read_rows_as_signals(text, layout);
  table::Rows rows(text, layout);
  Channels table;
  table.sampling_rate_hz = table::sampling_rate_in(text, layout);
  const std::vector<std::size_t> places = begin_channels(layout, lines_before, table);
  if (places.empty()) throw Fault{layout.numbers_line, 1, "has no column of numbers", "one or more"};
  while (rows.next_reading()) {
    table.line.push_back(lines_before + rows.line());
    if (table.line.size() * places.size() > most_text_numbers)
      throw Fault{rows.line(), 1, "is beyond " + std::to_string(most_text_numbers) + " numbers",
                  "fewer in a file"};
    for (std::size_t i = 0; i < places.size(); ++i) {
      double value = NAN;
      if (places[i] < rows.cells().size())
        value = layout.columns[places[i]].is_stamp ? rows.time_stamp(places[i]) : rows.reading(places[i]);
      table.channels[i].values.push_back(value);
    }
  }
  if (table.line.size() < 2)
    throw Fault{table.line.front() - lines_before, 1, "is the only row of numbers", "two or more"};
  for (std::size_t i = 0; i < places.size(); ++i)
    if (layout.columns[places[i]].is_stamp) count_from_first(table.channels[i].values);
  leave_out_empty(table);
  tell_notes(rows, lines_before, table);
  return table;
}

Channels read_delimited_text(std::string_view bytes, const std::string& name) {
  try {
    const std::string text = table::utf8_of(bytes);
    return text.starts_with("LabVIEW Measurement") ? read_labview_text(text) : read_table(text, 0);
  } catch (const Fault& fault) {
    throw ConfigError(name + ':' + std::to_string(fault.line) + ':' + std::to_string(fault.column) + ": " +
                      fault.wrong + ", allowed: " + fault.allowed);
  }
}

}  // namespace rubsweep::recording
