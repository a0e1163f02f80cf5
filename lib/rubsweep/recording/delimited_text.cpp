#include "rubsweep/recording/delimited_text.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "rubsweep/error.hpp"
#include "rubsweep/recording/cell.hpp"
#include "rubsweep/recording/name_unit.hpp"

namespace rubsweep::recording {
namespace {

/// Lines before which numbers must begin.
constexpr std::size_t longest_preamble = 200;

/// Takes the next line off the text; a line ends with LF, CR LF or CR.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos) {
    text = {};
  } else {
    text.remove_prefix(end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
  }
  return line;
}

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string_view::npos || line[begin] == '#' || line[begin] == '%';
}

std::optional<double> value_in(std::string_view cell, std::size_t column, const NumberStyle& style) {
  const auto number = number_in(cell, style);
  return number || column > 0 ? number : time_stamp_in(cell, style);
}

bool all_numbers(const std::vector<std::string_view>& cells, const NumberStyle& style) {
  bool any = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!value_in(cells[i], i, style)) return false;
    any = any || !cells[i].empty();
  }
  return any;
}

/// How a line of numbers is written; nothing where it is none. A comma parts cells only where nothing else
/// does.
std::optional<NumberStyle> style_of(std::string_view line) {
  constexpr std::array<NumberStyle, 5> several{
      {{'\t', false}, {'\t', true}, {';', false}, {';', true}, {',', false}}};
  for (const NumberStyle& style : several) {
    const auto cells = cells_of(line, style.separator);
    if (cells.size() > 1 && all_numbers(cells, style)) return style;
  }
  const NumberStyle alone{'\t', false};
  if (all_numbers(cells_of(line, '\t'), alone)) return alone;
  return std::nullopt;
}

/// Parts "name (unit)" or "name [unit]"; the endings _s and _m, which tables of the programs have, stay in
/// the name.
void name_channel(Channel& channel, std::string_view cell) {
  channel.name = cell;
  channel.unit = unit_in_ending(cell);
  if (cell.empty() || (cell.back() != ')' && cell.back() != ']')) return;
  const std::size_t begin = cell.rfind(cell.back() == ')' ? '(' : '[');
  if (begin == std::string_view::npos) return;
  channel.unit = cell.substr(begin + 1, cell.size() - begin - 2);
  channel.name = cell.substr(0, begin);
  while (!channel.name.empty() && channel.name.back() == ' ') channel.name.pop_back();
}

/// Whether the first cell of a line is a time stamp and no number.
bool begins_with_stamp(const std::vector<std::string_view>& cells, const NumberStyle& style) {
  return !number_in(cells.front(), style) && time_stamp_in(cells.front(), style);
}

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

std::string_view without_brackets(std::string_view unit) {
  const bool bracketed = unit.size() >= 2 && (unit.front() == '(' || unit.front() == '[');
  return bracketed ? unit.substr(1, unit.size() - 2) : unit;
}

/// Names, and below them perhaps units: the last lines before the numbers with as many cells.
void name_channels(std::vector<Channel>& channels, const std::vector<std::string_view>& preamble,
                   char separator) {
  std::vector<std::vector<std::string_view>> heads;
  for (const std::string_view line : preamble) {
    auto cells = cells_of(line, separator);
    if (cells.size() == channels.size()) heads.push_back(std::move(cells));
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (heads.empty()) {
      channels[i].name = "column " + std::to_string(i + 1);
    } else if (heads.size() == 1) {
      name_channel(channels[i], heads[0][i]);
    } else {
      name_channel(channels[i], heads[heads.size() - 2][i]);
      channels[i].unit = without_brackets(heads.back()[i]);
    }
  }
}

[[noreturn]] void refuse(const std::string& name, std::size_t line, std::size_t column,
                         const std::string& wrong, const std::string& allowed) {
  throw ConfigError(name + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + wrong +
                    ", allowed: " + allowed);
}

/// A cell fit for a message.
std::string quoted(std::string_view cell) {
  std::string text(cell.substr(0, 40));
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 32; }, '?');
  return '\'' + text + '\'';
}

}  // namespace

Channels read_delimited_text(std::string_view text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    refuse(name, 1, 1, "is text in UTF-16", "text in UTF-8 or ASCII");
  if (text.find('\0') != std::string_view::npos) refuse(name, 1, 1, "is no text", "a table of numbers");
  Channels table;
  std::optional<NumberStyle> style;
  std::vector<std::string_view> preamble;
  bool stamps = false;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    if (is_comment(line)) continue;
    if (!style) {
      if (!(style = style_of(line))) {
        preamble.push_back(line);
        if (preamble.size() > longest_preamble) break;
        continue;
      }
      table.channels.resize(cells_of(line, style->separator).size());
      stamps = begins_with_stamp(cells_of(line, style->separator), *style);
    }
    table.line.push_back(line_number);
    const auto cells = cells_of(line, style->separator);
    const std::size_t wanted = table.channels.size();
    if (cells.size() != wanted)
      refuse(name, line_number, 1, "has another number of cells, " + std::to_string(cells.size()),
             std::to_string(wanted) + " as in line " + std::to_string(table.line.front()));
    // The first numbers may be whole: a comma later on says how decimals are written.
    if (style->separator != ',' && line.find(',') != std::string_view::npos) style->decimal_comma = true;
    for (std::size_t i = 0; i < wanted; ++i) {
      const auto value = i == 0 && stamps ? time_stamp_in(cells[i], *style) : number_in(cells[i], *style);
      if (!value)
        refuse(name, line_number, static_cast<std::size_t>(cells[i].data() - line.data()) + 1,
               quoted(cells[i]) + (i == 0 && stamps ? " is no time stamp" : " is no number"),
               i == 0 && stamps       ? "hours:minutes:seconds, with or without a date before them"
               : style->decimal_comma ? "a number with a decimal comma"
                                      : "a number with a decimal point");
      table.channels[i].values.push_back(*value);
    }
  }
  if (!style)
    refuse(name, 1, 1, "has no numbers", "a table whose cells are parted by tabs, semicolons or commas");
  if (table.line.size() < 2) refuse(name, table.line.front(), 1, "is the only row of numbers", "two or more");
  if (stamps) count_from_first(table.channels.front().values);
  name_channels(table.channels, preamble, style->separator);
  if (stamps) table.channels.front().unit = std::string("s");
  return table;
}

}  // namespace rubsweep::recording
