#include "rubsweep/maps/table/layout.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace rubsweep::table {
namespace {

/// Number of lines at the begin from which the layout is found.
constexpr std::size_t most_lines = 1000;
constexpr std::array<char, 4> separators{'\t', ';', ',', ' '};

struct Line {
  std::string_view text;
  std::size_t number = 0, offset = 0;
};

/// First lines of a text without the blank ones.
std::vector<Line> first_lines(std::string_view text) {
  std::vector<Line> lines;
  const char* begin = text.data();
  for (std::size_t number = 1; !text.empty() && lines.size() < most_lines; ++number) {
    const auto offset = static_cast<std::size_t>(text.data() - begin);
    const std::string_view line = take_line(text);
    if (line.starts_with("***End_of_Header***"))
      lines.clear();  // lines above belong to LabVIEW's head, and the table comes below
    else if (line.find_first_not_of(" \t") != std::string_view::npos)
      lines.push_back({line, number, offset});
  }
  return lines;
}

bool is_number(std::string_view cell, std::size_t column, char separator) {
  if (cell.empty()) return false;
  for (const bool comma : {false, true}) {
    const NumberStyle style{separator, comma};
    if (number_in(cell, style) || (column == 0 && time_stamp_in(cell, style))) return true;
  }
  return false;
}

std::vector<bool> numbers_in(const std::vector<std::string_view>& cells, char separator) {
  std::vector<bool> numbers;
  for (std::size_t i = 0; i < cells.size(); ++i) numbers.push_back(is_number(cells[i], i, separator));
  return numbers;
}

/// Separator by which most lines have at least two numbers. A comma may also be a decimal sign. Since words
/// contain blanks, a blank is the separator only if it gives numbers in more than half of the lines.
char separator_of(const std::vector<Line>& lines) {
  char best = '\t';
  long most = 0;
  for (const char separator : separators) {
    const auto parts = std::ranges::count_if(lines, [&](const Line& line) {
      return !is_comment(line.text) &&
             std::ranges::count(numbers_in(cells_of(line.text, separator), separator), true) > 1;
    });
    if (separator == ' ' && 2 * parts <= std::ssize(lines)) continue;
    if (parts > most) best = separator;
    most = std::max<long>(most, parts);
  }
  return best;
}

/// Finds the number of cells of a row, and which columns hold numbers. Lines vote: for the row length a line
/// has as many votes as numbers, for the kind of a column the square of that. A few long rows thus outweigh a
/// head of keys and values.
void judge_columns(const std::vector<Line>& lines, Layout& layout) {
  std::map<std::size_t, std::ptrdiff_t> weight_of_count;
  const auto for_rows = [&](auto&& take) {
    for (const Line& line : lines) {
      if (is_comment(line.text)) continue;
      const auto cells = cells_of(line.text, layout.separator);
      const auto numbers = numbers_in(cells, layout.separator);
      const auto there = std::ranges::count(numbers, true);
      if (there > 0) take(line, cells, numbers, there);
    }
  };
  for_rows([&](const Line&, const auto& cells, const auto&, std::ptrdiff_t weight) {
    weight_of_count[cells.size()] += weight;
  });
  if (weight_of_count.empty())
    throw Fault{1, 1, "has no numbers", "a table whose cells are parted by tabs, semicolons or commas"};
  const auto heavier = [](const auto& a, const auto& b) { return a.second < b.second; };
  const std::size_t count = std::ranges::max_element(weight_of_count, heavier)->first;
  layout.columns.resize(count);
  std::vector<std::ptrdiff_t> votes(count, 0);
  for_rows([&](const Line& line, const auto& cells, const auto& numbers, std::ptrdiff_t weight) {
    for (std::size_t i = 0; i < count && cells.size() == count; ++i) {
      if (cells[i].empty()) continue;
      votes[i] += (numbers[i] ? 1 : -1) * weight * weight;
      if (!numbers[i] && layout.columns[i].text_line == 0) layout.columns[i].text_line = line.number;
    }
  });
  for (std::size_t i = 0; i < count; ++i) {
    layout.columns[i].is_text = votes[i] < 0;
    if (votes[i] > 0) layout.fewest_cells = i + 1;
  }
}

/// Whether a line is a row of numbers. Up to half of the numbers may be missing.
bool is_row(const Line& line, const Layout& layout) {
  const auto cells = cells_of(line.text, layout.separator);
  if (cells.size() < layout.fewest_cells) return false;
  std::size_t numbers = 0, there = 0;
  for (std::size_t i = 0; i < layout.fewest_cells; ++i) {
    if (layout.columns[i].is_text) continue;
    ++numbers;
    if (cells[i].empty()) continue;
    if (!is_number(cells[i], i, layout.separator)) return false;
    ++there;
  }
  return 2 * there >= numbers;
}

bool is_unit_row(const std::vector<std::string_view>& cells) {
  return std::ranges::any_of(cells, [](auto cell) { return !cell.empty(); }) &&
         std::ranges::all_of(cells, [](auto cell) { return cell.empty() || is_unit(cell); });
}

/// Whether cells are names of the columns. The first cell may be empty, above a column of row numbers.
/// `all_differ` = false accepts repeated names, for a table that has no line with all names different.
bool are_names(const std::vector<std::string_view>& cells, const Layout& layout, bool all_differ = true) {
  if (cells.size() < layout.fewest_cells) return false;
  std::size_t once = 0, named = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty() && i > 0 && i < layout.fewest_cells) return false;
    if (is_number(cells[i], i, layout.separator)) return false;
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
  // Columns behind the numbers, which have a name but cells only in some rows.
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
    if (!cells[i].empty())
      layout.columns[i].heading.unit = bracketed.unit.empty() ? cells[i] : bracketed.unit;
  }
}

std::string_view uncommented(std::string_view line) {
  return line.substr(std::min(line.find_first_not_of(" \t#%"), line.size()));
}

/// Refuses a row of numbers above the table, which would otherwise be lost.
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
      if (is_unit_row(cells) && cells.size() >= layout.fewest_cells) {
        if (units.empty()) units = cells;
      } else if (are_names(cells, layout, all_differ)) {
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
  const std::vector<Line> lines = first_lines(text);
  Layout layout{.separator = separator_of(lines), .columns = {}};
  judge_columns(lines, layout);
  const auto first = std::ranges::find_if(
      lines, [&](const Line& line) { return !is_comment(line.text) && is_row(line, layout); });
  if (first == lines.end())
    throw Fault{1, 1, "has no numbers", "a table whose cells are parted by tabs, semicolons or commas"};
  layout.numbers_offset = first->offset;
  layout.numbers_line = first->number;
  find_names(layout, {lines.begin(), first});
  refuse_other_rows(layout, {lines.begin(), first});
  return layout;
}

Layout layout_of(std::string_view text, const std::function<bool(const Heading&)>& is_name) {
  const std::vector<Line> lines = first_lines(text);
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
      return !is_comment(line.text) && is_number(cells_of(line.text, ' ')[0], 1, ' ');
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
    // Names with units behind them may stand one line above, so that a name here may be missing.
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
