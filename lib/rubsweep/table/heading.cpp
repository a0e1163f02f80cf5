#include "rubsweep/table/heading.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace rubsweep::table {
namespace {

/// In small letters, as plain_unit writes them.
constexpr std::array<std::string_view, 66> units{
    "s",      "ms",    "us",    "sec",   "secs",   "second",  "seconds", "min",    "h",       "m",     "mm",
    "um",     "nm",    "cm",    "in",    "inch",   "mil",     "mils",    "micron", "microns", "v",     "mv",
    "volt",   "volts", "a",     "ma",    "hz",     "khz",     "rpm",     "1/min",  "rev/min", "r/min", "min1",
    "u/min",  "rev/s", "rad/s", "n",     "kn",     "n/m",     "n/mm",    "n/um",   "kn/m",    "kn/mm", "mn/m",
    "lbf/in", "lb/in", "ns/m",  "ns/mm", "kns/m",  "lbfs/in", "lbs/in",  "kg",     "kg/s",    "m/s",   "mm/s",
    "in/s",   "m/s2",  "g",     "deg",   "\u00b0", "rad",     "\u00b0c", "%",      "pa",      "bar",   "fs"};

bool is_bracketed(std::string_view cell) {
  return cell.size() > 2 &&
         ((cell.front() == '(' && cell.back() == ')') || (cell.front() == '[' && cell.back() == ']'));
}

}  // namespace

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
    } else if (std::string_view(" *.-_^").find(unit[i]) == std::string_view::npos) {
      plain += unit[i];
    }
  }
  return plain;
}

bool is_unit(std::string_view cell) {
  if (is_bracketed(cell) || cell == "-") return true;
  std::string plain = plain_unit(cell);
  std::ranges::transform(plain, plain.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(units, plain) != units.end();
}

}  // namespace rubsweep::table
