#include "rubsweep/maps/table/judged_columns.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "rubsweep/maps/table/time_stamp.hpp"

namespace rubsweep::table {
namespace {

/// Number of lines from which the layout is found.
constexpr std::size_t most_lines = 1000;

bool is_stamp(std::string_view cell, char separator) {
  return cell.find(':') != std::string_view::npos &&
         (time_stamp_in(cell, {separator, false}) || time_stamp_in(cell, {separator, true}));
}

}  // namespace

bool Lines::read_on(std::vector<Line>& lines) {
  constexpr std::size_t most_kept = 50;
  if (rest_.empty()) return false;
  if (lines.size() > most_kept) lines.erase(lines.begin(), lines.end() - most_kept);
  for (const std::size_t end = lines.size() + most_lines; !rest_.empty() && lines.size() < end; ++number_) {
    const auto offset = static_cast<std::size_t>(rest_.data() - begin_);
    const std::string_view line = take_line(rest_);
    if (line.starts_with("***End_of_Header***"))
      lines.clear();  // header lines of LabVIEW, before the table
    else if (line.find_first_not_of(" \t") != std::string_view::npos)
      lines.push_back({line, number_, offset});
  }
  return true;
}

bool is_number(std::string_view cell, char separator) {
  return !cell.empty() && (number_in(cell, {separator, false}) || number_in(cell, {separator, true}) ||
                           is_stamp(cell, separator));
}

std::vector<bool> numbers_in(const std::vector<std::string_view>& cells, char separator) {
  std::vector<bool> numbers;
  for (std::size_t i = 0; i < cells.size(); ++i) numbers.push_back(is_number(cells[i], separator));
  return numbers;
}

char separator_of(const std::vector<Line>& lines) {
  char best = '\t';
  long most = 0;
  for (const char separator : separators) {
    const auto parts = std::ranges::count_if(lines, [&](const Line& line) {
      if (is_comment(line.text)) return false;
      const auto numbers = numbers_in(cells_of(line.text, separator), separator);
      const auto there = std::ranges::count(numbers, true);
      return there > 1 && (separator != ' ' || 2 * there > std::ssize(numbers));
    });
    if (separator == ' ' && (2 * parts <= std::ssize(lines) || 10 * parts <= 11 * most)) continue;
    if (parts > most) best = separator;
    most = std::max<long>(most, parts);
  }
  return best;
}

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
  if (count > most_cells)
    throw Fault{1, 1, "has more than " + std::to_string(most_cells) + " cells in a line", "fewer columns"};
  layout.columns.resize(count);
  struct Votes {
    std::ptrdiff_t numbers = 0, stamps = 0;
    std::size_t filled = 0;
    bool any_stamp = false;
  };
  std::vector<Votes> votes(count);
  std::size_t rows = 0;
  for_rows([&](const Line& line, const auto& cells, const auto& numbers, std::ptrdiff_t weight) {
    if (cells.size() != count) return;
    ++rows;
    for (std::size_t i = 0; i < count; ++i) {
      if (cells[i].empty()) continue;
      ++votes[i].filled;
      votes[i].numbers += (numbers[i] ? 1 : -1) * weight * weight;
      const bool stamp = numbers[i] && is_stamp(cells[i], layout.separator);
      votes[i].any_stamp = votes[i].any_stamp || stamp;
      if (numbers[i]) votes[i].stamps += stamp ? 1 : -1;
      if (!numbers[i] && layout.columns[i].text_line == 0) layout.columns[i].text_line = line.number;
    }
  });
  for (std::size_t i = 0; i < count; ++i) {
    Column& column = layout.columns[i];
    // Words, numbers and then empty cells, next to a column of words: keys and values of an oscilloscope
    // beside its first readings.
    const bool beside =
        i > 0 && layout.columns[i - 1].is_text && column.text_line > 0 && 2 * votes[i].filled < rows;
    layout.head_beside = layout.head_beside || beside;
    column.is_text = beside || votes[i].numbers < 0;
    column.is_stamp = votes[i].any_stamp && votes[i].stamps >= 0;
    column.is_empty = votes[i].filled == 0;
    if (votes[i].numbers > 0 && !beside) layout.fewest_cells = i + 1;
  }
}

bool is_row(const Line& line, const Layout& layout) {
  const auto cells = cells_of(line.text, layout.separator);
  if (cells.size() < layout.fewest_cells) return false;
  std::size_t numbers = 0, there = 0;
  for (std::size_t i = 0; i < layout.fewest_cells; ++i) {
    if (layout.columns[i].is_text) continue;
    ++numbers;
    if (cells[i].empty()) continue;
    if (!is_number(cells[i], layout.separator)) return false;
    ++there;
  }
  return 2 * there >= numbers;
}

}  // namespace rubsweep::table
