#include "rubsweep/measurement/recording/delimited_text.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/table/encoding.hpp"
#include "rubsweep/maps/table/rows.hpp"
#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {
namespace {

using table::Fault;

/// Seconds since the first stamp; stamps without a date begin again at midnight.
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

/// Cells of the line of a LabVIEW head that begins with `key`; empty where there is none.
std::vector<std::string_view> labview_line(std::string_view text, char separator, std::string_view key) {
  while (!text.empty()) {
    const auto cells = table::cells_of(table::take_line(text), separator);
    if (cells.front() == key) return cells;
    if (cells.front() == "X_Value") break;
  }
  return {};
}

/// Units and sampling rate that the head of a LabVIEW measurement says. Throws Fault for what is no one
/// table.
void read_labview_head(std::string_view text, const table::Layout& layout, Channels& table) {
  std::size_t sections = 0, line = 0;
  for (std::string_view rest = text; !rest.empty();) {
    ++line;
    if (table::take_line(rest).starts_with("X_Value") && ++sections > 1)
      throw Fault{line, 1, "begins another segment of LabVIEW", "one segment in a file"};
  }
  const auto said = [&](std::string_view key) { return labview_line(text, layout.separator, key); };
  if (const auto columns = said("X_Columns"); columns.size() > 1 && columns[1] == "Multi")
    throw Fault{1, 1, "has times of its own for each signal, X_Columns Multi", "X_Columns One or No"};
  const auto units = said("Y_Unit_Label");
  for (std::size_t i = 1; i < std::min(units.size(), layout.columns.size()); ++i)
    for (Channel& channel : table.channels)
      if (channel.name == layout.columns[i].heading.name && channel.unit.empty()) channel.unit = units[i];
  if (const auto steps = said("Delta_X"); steps.size() > 1) {
    std::string step(steps[1]);
    std::ranges::replace(step, ',', '.');
    const double step_s = table::number_in(step, {}).value_or(0);
    if (step_s > 0) table.sampling_rate_hz = 1 / step_s;
  }
}

Channels read_text(std::string_view text) {
  const table::Layout layout = table::layout_of(text);
  table::Rows rows(text, layout);
  Channels table;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < layout.columns.size(); ++i) {
    const table::Column& column = layout.columns[i];
    const std::string name =
        column.heading.name.empty() ? "column " + std::to_string(i + 1) : column.heading.name;
    if (column.is_text) {
      table.left_out.push_back({name, column.text_line > 0
                                          ? "holds text, as in line " + std::to_string(column.text_line)
                                          : "holds text"});
      continue;
    }
    places.push_back(i);
    table.channels.push_back({name, column.heading.unit, {}});
    if (column.heading.unit.empty()) table.channels.back().unit = unit_in_ending(name);
  }
  bool stamps = false;
  while (rows.next()) {
    if (table.line.empty()) stamps = rows.begins_with_stamp();
    table.line.push_back(rows.line());
    for (std::size_t i = 0; i < places.size(); ++i) {
      double value = NAN;
      if (places[i] < rows.cells().size())
        value = places[i] == 0 && stamps ? rows.time_stamp() : rows.number(places[i]);
      table.channels[i].values.push_back(value);
    }
  }
  if (table.line.size() < 2) throw Fault{table.line.front(), 1, "is the only row of numbers", "two or more"};
  if (stamps) {
    count_from_first(table.channels.front().values);
    table.channels.front().unit = std::string("s");
  }
  if (text.starts_with("LabVIEW Measurement")) read_labview_head(text, layout, table);
  return table;
}

}  // namespace

Channels read_delimited_text(std::string_view bytes, const std::string& name) {
  try {
    return read_text(table::utf8_of(bytes));
  } catch (const Fault& fault) {
    throw ConfigError(name + ':' + std::to_string(fault.line) + ':' + std::to_string(fault.column) + ": " +
                      fault.wrong + ", allowed: " + fault.allowed);
  }
}

}  // namespace rubsweep::recording
