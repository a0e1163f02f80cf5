#include "rubsweep/maps/table/layout.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "rubsweep/maps/table/head.hpp"
#include "rubsweep/maps/table/judged_columns.hpp"

namespace rubsweep::table {
namespace {

bool is_unit_row(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(cells, [](auto cell) { return !cell.empty(); }) &&
         std::ranges::all_of(cells, [](auto cell) { return cell.empty() || is_unit(cell); });
}

/// Whether the words of a row are units, with numbers among them: some oscilloscopes write a step of time
/// there.
bool is_unit_row_with_numbers(const std::vector<std::string_view>& cells, char separator) {
  std::size_t words = 0, units = 0, numbers = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    const bool number = is_number(cell, separator);
    numbers += number;
    words += !number;
    units += !number && is_unit(cell);
  }
  return numbers > 0 && units > 0 && 2 * units >= words && words >= numbers;
}

/// Whether the cells after the first one are the numbers 1, 2, ... of the columns.
bool count_columns(const std::vector<std::string_view>& cells, const Layout& layout) {
  if (cells.size() < std::max<std::size_t>(layout.fewest_cells, 2) || cells[0].empty() ||
      is_number(cells[0], layout.separator))
    return false;
  for (std::size_t i = 1; i < layout.fewest_cells; ++i)
    if (number_in(cells[i], {}) != static_cast<double>(i)) return false;
  return true;
}

/// Whether the cells are names of columns. The first cell may be empty, for a column of row numbers. With
/// `all_differ` false some names may be equal; a user who refers to such a name gets an error.
bool are_names(const std::vector<std::string_view>& cells, const Layout& layout, bool all_differ = true) {
  if (cells.size() < layout.fewest_cells) return false;
  std::size_t once = 0, named = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty() && i > 0 && i < layout.fewest_cells) return false;
    if (is_number(cells[i], layout.separator)) return false;
    if (cells[i].empty()) continue;
    once += std::ranges::count(cells, cells[i]) == 1;
    ++named;
  }
  if (all_differ ? once < named : once == 0) return false;
  return !(layout.fewest_cells == 1 && cells[0].empty());
}

void set_names(Layout& layout, const Line& line, std::string_view text) {
  const auto cells = cells_of(text, layout.separator);
  layout.names_line = line.number;
  // Columns after the numbers that have a name but cells only in some rows.
  for (std::size_t i = layout.columns.size(); i < cells.size(); ++i)
    layout.columns.push_back({.heading = {}, .is_text = true});
  for (std::size_t i = 0; i < cells.size(); ++i) {
    layout.columns[i].heading = heading_of(cells[i]);
    layout.columns[i].column = static_cast<std::size_t>(cells[i].data() - line.text.data()) + 1;
  }
}

void set_units(Layout& layout, const std::vector<std::string_view>& cells) {
  for (std::size_t i = 0; i < std::min(cells.size(), layout.columns.size()); ++i) {
    const Heading bracketed = heading_of(cells[i]);
    if (!cells[i].empty() && !is_number(cells[i], layout.separator))
      layout.columns[i].heading.unit = bracketed.unit.empty() ? cells[i] : bracketed.unit;
  }
}

/// A header line with units after a key: "VUnit,V,V".
bool is_keyed_unit_row(const std::vector<std::string_view>& cells, const Layout& layout) {
  constexpr std::array<std::string_view, 6> keys{"vunit", "verticalunits", "vertical units",
                                                 "unit",  "units",         "einheit"};
  return cells.size() >= layout.fewest_cells && cells.size() > 1 &&
         std::ranges::find(keys, in_small_letters(cells[0])) != keys.end() &&
         is_unit_row({cells.begin() + 1, cells.end()});
}

std::string_view uncommented(std::string_view line) {
  return line.substr(std::min(line.find_first_not_of(" \t#%"), line.size()));
}

/// Refuses a row of numbers above the table, because it would be lost.
void refuse_other_rows(const Layout& layout, const std::vector<Line>& above) {
  for (const Line& line : above) {
    if (line.number < layout.names_line || is_comment(line.text)) continue;
    const auto cells = cells_of(line.text, layout.separator);
    const auto numbers = numbers_in(cells, layout.separator);
    if (cells.size() > 1 && std::ranges::count(numbers, false) == 0)
      throw Fault{
          line.number, 1, "has another number of cells, " + std::to_string(cells.size()),
          std::to_string(layout.columns.size()) + " as in line " + std::to_string(layout.numbers_line)};
  }
}

/// Takes names and units from the lines above the numbers.
void find_names(Layout& layout, const std::vector<Line>& above) {
  std::vector<std::string_view> units;
  const Line* names = nullptr;
  for (const bool all_differ : {true, false}) {
    for (auto line = above.rbegin(); line != above.rend() && names == nullptr; ++line) {
      if (is_comment(line->text)) continue;
      const auto cells = cells_of(line->text, layout.separator);
      if (cells.size() >= layout.fewest_cells &&
          (is_unit_row(cells) || is_unit_row_with_numbers(cells, layout.separator))) {
        if (units.empty()) units = cells;
      } else if (is_keyed_unit_row(cells, layout)) {
        continue;  // its units are taken below
      } else if (are_names(cells, layout, all_differ) || (!units.empty() && count_columns(cells, layout))) {
        names = &*line;
      } else if (!all_differ) {
        break;  // here only the line directly above the numbers counts
      }
    }
  }
  if (names != nullptr) {
    set_names(layout, *names, names->text);
  } else if (!above.empty() && is_comment(above.back().text) &&
             are_names(cells_of(uncommented(above.back().text), layout.separator), layout)) {
    set_names(layout, above.back(), uncommented(above.back().text));
  } else if (!units.empty() && are_names(units, layout)) {  // names that look like units
    for (const Line& line : above)
      if (line.text.data() <= units[0].data() && units[0].data() <= line.text.data() + line.text.size())
        return set_names(layout, line, line.text);
  }
  set_units(layout, units);
  for (const Line& line : above) {
    auto cells = cells_of(line.text, layout.separator);
    if (!units.empty() || !is_keyed_unit_row(cells, layout)) continue;
    cells[0] = {};
    set_units(layout, cells);
  }
}

}  // namespace

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find_first_of("\r\n");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size()
                                                   : end + (text.substr(end, 2) == "\r\n" ? 2 : 1));
  return line;
}

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string_view::npos || line[begin] == '#' || line[begin] == '%';
}

Layout layout_of(std::string_view text) {
  std::vector<Line> lines;
  Lines rest(text);
  // Skips a long header: most of the lines read, or the last ones, must have numbers.
  const auto has_number = [](const Line& line) {
    return !is_comment(line.text) && std::ranges::any_of(separators, [&](char separator) {
      const auto numbers = std::ranges::count(numbers_in(cells_of(line.text, separator), separator), true);
      return numbers > (separator == ' ' ? 1 : 0);
    });
  };
  while (rest.read_on(lines) && 2 * std::ranges::count_if(lines, has_number) < std::ssize(lines) &&
         std::ranges::none_of(lines.end() - std::min<std::ptrdiff_t>(std::ssize(lines), 20), lines.end(),
                              has_number)) {
  }
  Layout layout{.separator = separator_of(lines), .columns = {}};
  judge_columns(lines, layout);
  const auto first = std::ranges::find_if(
      lines, [&](const Line& line) { return !is_comment(line.text) && is_row(line, layout); });
  if (first == lines.end())
    throw Fault{1, 1, "has no numbers", "a table whose cells are parted by tabs, semicolons or commas"};
  layout.numbers_offset = first->offset;
  layout.numbers_line = first->number;
  find_names(layout, {lines.begin(), first});
  if (layout.head_beside && layout.names_line == 0) name_from_beside(text, layout);
  refuse_other_rows(layout, {lines.begin(), first});
  return layout;
}

Layout layout_of(std::string_view text, const std::function<bool(const Heading&)>& is_name) {
  std::vector<Line> lines;
  Lines(text).read_on(lines);
  Layout layout;
  long most = 0;
  std::size_t names = 0;
  for (const bool comments : {false, true}) {
    for (std::size_t i = 0; i < lines.size() && (!comments || most == 0); ++i) {
      for (const char separator : separators) {
        if (is_comment(lines[i].text) != comments) continue;
        const auto known = std::ranges::count_if(cells_of(uncommented(lines[i].text), separator),
                                                 [&](auto cell) { return is_name(heading_of(cell)); });
        if (known > most) layout.separator = separator, names = i;
        most = std::max<long>(most, known);
      }
    }
  }
  const bool holds_cells =
      std::ranges::any_of(lines, [](const Line& line) { return !is_comment(line.text); });
  if (most == 0 && holds_cells) {
    const auto number = std::ranges::find_if(lines, [](const Line& line) {
      return !is_comment(line.text) && is_number(cells_of(line.text, ' ')[0], ' ');
    });
    const bool any = number != lines.end();
    const std::string first(any ? cells_of(number->text, ' ')[0] : "");
    const std::string wrong = "no line of the file has names of columns that are known";
    throw Fault{any ? number->number : 1, 1,
                any ? wrong + ", and numbers begin with '" + first + '\'' : wrong,
                "a line of names as the keys are, perhaps with units, then lines of numbers"};
  }
  if (most == 0) throw Fault{1, 1, "the file holds no table", "a line of names, then lines of numbers"};
  layout.columns.resize(cells_of(uncommented(lines[names].text), layout.separator).size());
  set_names(layout, lines[names], uncommented(lines[names].text));
  if (names > 0) {
    // Names may be in the line above, with their units in this line; a name may then be missing here.
    const auto above = cells_of(lines[names - 1].text, layout.separator);
    for (std::size_t i = 0; i < std::min(above.size(), layout.columns.size()); ++i)
      if (layout.columns[i].heading.name.empty()) layout.columns[i].heading.name = heading_of(above[i]).name;
  }
  std::size_t next = names + 1;
  while (next < lines.size() && is_comment(lines[next].text)) ++next;
  if (next < lines.size()) {
    const auto cells = cells_of(lines[next].text, layout.separator);
    const bool units = is_unit_row(cells);
    if (units) set_units(layout, cells);
    next += units;
  }
  layout.numbers_offset = next < lines.size() ? lines[next].offset : text.size();
  layout.numbers_line = next < lines.size() ? lines[next].number : 0;
  return layout;
}

}  // namespace rubsweep::table
