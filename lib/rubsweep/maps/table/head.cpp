#include "rubsweep/maps/table/head.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "rubsweep/maps/table/cell.hpp"
#include "rubsweep/maps/table/unit.hpp"

namespace rubsweep::table {
namespace {

constexpr std::array<std::string_view, 12> rates{
    "rate",         "samplerate",        "samplingrate",     "sampfreq", "samplefrequency", "samplefreq",
    "samplingfreq", "samplingfrequency", "samplespersecond", "scanrate", "abtastrate",      "fs"};
constexpr std::array<std::string_view, 13> steps{
    "sampleinterval", "samplinginterval", "sampletime", "sampleperiod", "samplingperiod", "deltax", "deltat",
    "tinc",           "increment",        "xincrement", "timestep",     "hresolution",    "dt"};

/// Number of lines that are searched for keys and values beside a table.
constexpr std::size_t most_lines_beside = 100;

/// A key in the form of the lists above.
std::string plain_key(std::string_view cell) {
  std::string plain = in_small_letters(heading_of(cell).name);
  std::erase_if(plain, [](char c) { return std::string_view(" _-:=\"").find(c) != std::string_view::npos; });
  return plain;
}

/// A number and the words after it.
struct Amount {
  double number = 0;
  std::string unit{};
};

std::optional<Amount> quantity_in(std::string_view cell) {
  if (const std::size_t colon = cell.rfind(':'); colon != std::string_view::npos)
    cell.remove_prefix(colon + 1);
  const std::size_t begin = cell.find_first_not_of(' ');
  if (begin == std::string_view::npos) return std::nullopt;
  cell.remove_prefix(begin);
  constexpr std::string_view digits = "0123456789+-.,eE";
  for (std::size_t end = std::min(cell.find_first_not_of(digits), cell.size()); end > 0; --end) {
    if (may_part_thousands(cell.substr(0, end))) return std::nullopt;
    for (const bool comma : {false, true}) {
      const auto number = number_in(cell.substr(0, end), {';', comma});
      if (number && std::isfinite(*number)) return Amount{*number, plain_unit(cell.substr(end))};
    }
  }
  return std::nullopt;
}

/// A frequency without a key. (A frequency with a key may be that of a filter.)
std::optional<double> frequency_in(std::string_view cell) {
  if (cell.find(':') != std::string_view::npos) return std::nullopt;
  const auto quantity = quantity_in(cell);
  if (!quantity || !in_small_letters(quantity->unit).ends_with("hz")) return std::nullopt;
  const auto unit = unit_of(quantity->unit);
  return unit ? std::optional(quantity->number * unit->in_si) : std::nullopt;
}

/// All rates given in a line of text; `below` is the next line.
std::vector<double> rates_in(const std::vector<std::string_view>& cells,
                             const std::vector<std::string_view>& below) {
  std::vector<double> found;
  const auto add = [&](std::optional<double> rate) {
    if (rate && *rate > 0 && std::isfinite(*rate)) found.push_back(*rate);
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t mark = cells[i].find_first_of("=:");
    const bool pair = mark != std::string_view::npos && mark + 1 < cells[i].size();
    if (pair) add(rate_of(cells[i].substr(0, mark), cells[i].substr(mark + 1)));
    if (pair) continue;
    const auto beside = i + 1 < cells.size() ? rate_of(cells[i], cells[i + 1]) : std::nullopt;
    add(beside);
    if (!beside && below.size() == cells.size()) add(rate_of(cells[i], below[i]));
  }
  if (found.empty() &&
      std::ranges::all_of(cells, [](auto cell) { return cell.empty() || frequency_in(cell); }))
    for (const std::string_view cell : cells) add(cell.empty() ? std::nullopt : frequency_in(cell));
  return found;
}

std::vector<std::vector<std::string_view>> head_of(std::string_view text, const Layout& layout) {
  std::vector<std::vector<std::string_view>> head;
  const char* const end = text.data() + layout.numbers_offset;
  std::size_t beside = 0;
  while (!text.empty() && (text.data() < end || (layout.head_beside && ++beside < most_lines_beside))) {
    std::string_view line = take_line(text);
    line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
    head.push_back(cells_of(line, layout.separator));
  }
  return head;
}

}  // namespace

std::optional<double> rate_of(std::string_view key, std::string_view value) {
  const std::string plain = plain_key(key);
  const bool rate = std::ranges::find(rates, plain) != rates.end(),
             step = std::ranges::find(steps, plain) != steps.end();
  const auto quantity = rate || step ? quantity_in(value) : std::nullopt;
  if (!quantity || !(quantity->number > 0)) return std::nullopt;
  const std::string unit = quantity->unit.empty() ? plain_unit(heading_of(key).unit) : quantity->unit;
  if (unit.empty()) return rate ? quantity->number : 1 / quantity->number;
  const auto known = unit_of(unit);
  const bool fits =
      known && (rate ? in_small_letters(unit).ends_with("hz") : known->quantity == Quantity::time);
  if (!fits) return std::nullopt;
  return rate ? quantity->number * known->in_si : 1 / (quantity->number * known->in_si);
}

std::optional<double> sampling_rate_in(std::string_view text, const Layout& layout) {
  const auto head = head_of(text, layout);
  std::optional<double> said;
  for (std::size_t i = 0; i < head.size(); ++i) {
    static const std::vector<std::string_view> none;
    for (const double rate : rates_in(head[i], i + 1 < head.size() ? head[i + 1] : none)) {
      constexpr double rounding = 1e-6;
      if (said && std::abs(rate - *said) > rounding * *said) return std::nullopt;
      said = said.value_or(rate);
    }
  }
  return said;
}

void name_from_beside(std::string_view text, Layout& layout) {
  std::size_t lines = 0;
  while (!text.empty() && ++lines < most_lines_beside) {
    const auto cells = cells_of(take_line(text), layout.separator);
    for (std::size_t key = 0; key + 1 < std::min(cells.size(), layout.columns.size()); ++key) {
      if (!layout.columns[key].is_text || !layout.columns[key + 1].is_text) continue;
      // The columns of numbers after key and value: times, then readings.
      std::size_t first = key + 2;
      const auto holds_numbers = [&](std::size_t i) {
        return !layout.columns[i].is_text && !layout.columns[i].is_empty;
      };
      while (first < layout.columns.size() && !holds_numbers(first)) ++first;
      if (first + 1 >= layout.columns.size() || !holds_numbers(first + 1)) continue;
      const std::string said = plain_key(cells[key]);
      const std::string value(cells[key + 1]);
      Heading& times = layout.columns[first].heading;
      if (times.name.empty()) times = {first > 4 ? "time " + std::to_string(first + 1) : "time", "s"};
      if (said == "source") layout.columns[first + 1].heading.name = value;
      if (said == "verticalunits") layout.columns[first + 1].heading.unit = value;
      if (said == "horizontalunits") times.unit = value;
    }
  }
}

}  // namespace rubsweep::table
