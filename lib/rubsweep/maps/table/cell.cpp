#include "rubsweep/maps/table/cell.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "rubsweep/maps/table/unit.hpp"

namespace rubsweep::table {
namespace {

bool is_bracketed(std::string_view cell) {
  return cell.size() > 2 &&
         ((cell.front() == '(' && cell.back() == ')') || (cell.front() == '[' && cell.back() == ']'));
}

std::string_view trimmed(std::string_view cell) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = cell.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return cell.substr(cell.size());
  cell = cell.substr(begin, cell.find_last_not_of(blanks) - begin + 1);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
  return cell;
}

/// Splits a line at blanks. A unit in brackets belongs to the cell before it, and blanks inside brackets and
/// quotes do not separate.
std::vector<std::string_view> cells_between_blanks(std::string_view line) {
  constexpr std::string_view blanks = " \t\r", opening = "([\"", closing = ")]\"";
  std::vector<std::string_view> cells;
  // searched for only once if the closing sign is missing
  std::array<bool, opening.size()> closes{true, true, true};
  std::size_t end = 0;
  while (cells.size() <= most_cells) {
    const std::size_t begin = line.find_first_not_of(blanks, end);
    if (begin == std::string_view::npos) break;
    for (end = begin; end < line.size() && blanks.find(line[end]) == std::string_view::npos; ++end) {
      const std::size_t kind = opening.find(line[end]);
      if (kind == std::string_view::npos || !closes[kind]) continue;
      const std::size_t closed = line.find(closing[kind], end + 1);
      closes[kind] = closed != std::string_view::npos;
      if (closes[kind]) end = closed;
    }
    const bool unit = !cells.empty() && (line[begin] == '(' || line[begin] == '[') && !is_bracketed(cells[0]);
    if (unit) {
      const auto first = static_cast<std::size_t>(cells.back().data() - line.data());
      cells.back() = line.substr(first, end - first);
    } else {
      cells.push_back(trimmed(line.substr(begin, end - begin)));
    }
  }
  if (cells.empty()) cells.push_back(line.substr(line.size()));
  return cells;
}

}  // namespace

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == ' ') return cells_between_blanks(line);
  while (true) {
    // A separator inside quotes does not count. A quote without its end is part of the text.
    const std::size_t begin = line.find_first_not_of(" \t\r");
    const bool quoted = begin != std::string_view::npos && line[begin] == '"';
    const std::size_t closed = quoted ? line.find('"', begin + 1) : std::string_view::npos;
    const std::size_t end = line.find(separator, closed == std::string_view::npos ? 0 : closed);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos || cells.size() > most_cells) return cells;
    line.remove_prefix(end + 1);
  }
}

std::optional<double> number_in(std::string_view cell, const NumberStyle& style) {
  if (cell.empty() || cell == "NaN" || cell == "nan") return std::numeric_limits<double>::quiet_NaN();
  std::string point(cell);
  if (style.decimal_comma) {
    if (cell.find('.') != std::string_view::npos) return std::nullopt;  // dots that separate thousands
    if (const std::size_t comma = point.find(','); comma != std::string::npos) point[comma] = '.';
  }
  if (const std::size_t exponent = point.find_first_of("Dd");
      exponent != std::string::npos && point.find_first_of("+-", exponent) == exponent + 1)
    point[exponent] = 'e';  // Fortran writes 1.0D+03
  cell = point;
  if (cell.front() == '+') cell.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool may_part_thousands(std::string_view cell) {
  if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
  cell = cell.substr(0, cell.find('.'));
  std::size_t group = cell.find(',');
  if (group == std::string_view::npos || group == 0 || group > 3) return false;
  for (; group < cell.size(); group += 4)
    if (cell[group] != ',' || cell.substr(group + 1, 3).size() < 3) return false;
  return cell.find_first_not_of("0123456789,") == std::string_view::npos;
}

Heading heading_of(std::string_view cell) {
  if (cell.empty() || (cell.back() != ')' && cell.back() != ']')) return {std::string(cell), ""};
  const std::size_t begin = cell.rfind(cell.back() == ')' ? '(' : '[');
  if (begin == std::string_view::npos) return {std::string(cell), ""};
  Heading heading{std::string(cell.substr(0, begin)),
                  std::string(cell.substr(begin + 1, cell.size() - begin - 2))};
  while (!heading.name.empty() && heading.name.back() == ' ') heading.name.pop_back();
  return heading;
}

std::string plain_unit(std::string_view unit) {
  constexpr std::array<std::string_view, 2> micro{"\u00b5", "\u03bc"}, dots{"\u00b7", "\u22c5"};
  std::string plain;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const auto is = [&](std::string_view sign) { return unit.substr(i).starts_with(sign); };
    if (std::ranges::any_of(micro, is)) {
      plain += 'u';
      ++i;
    } else if (const auto dot = std::ranges::find_if(dots, is); dot != dots.end()) {
      i += dot->size() - 1;
    } else if (is("\u00b2")) {
      plain += '2';
      ++i;
    } else if (std::string_view(" *.-_^").find(unit[i]) == std::string_view::npos) {
      plain += unit[i];
    }
  }
  return plain;
}

bool is_unit(std::string_view cell) {
  if (is_bracketed(cell) || cell == "-") return true;
  return unit_of(cell).has_value();
}

std::string printable(std::string_view text) {
  constexpr unsigned char blank = 32, deleted = 127;
  std::string shown(text);
  std::ranges::replace_if(
      shown, [](unsigned char c) { return c < blank || c == deleted; }, '?');
  return shown;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

}  // namespace rubsweep::table
