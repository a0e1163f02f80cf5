#include "rubsweep/maps/config/machine/ansys_bearing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr unsigned lines_of_speed = 3;
constexpr std::array<std::size_t, lines_of_speed> numbers_of_line{2, 4, 4};

struct Line {
  std::size_t number = 0;
  std::string_view text;
  std::vector<std::string_view> cells = table::cells_of(text, ' ');

  bool has_numbers(std::size_t count) const {
    return cells.size() == count && std::ranges::all_of(cells, [](std::string_view cell) {
             return std::isfinite(table::number_in(cell, {' '}).value_or(NAN));
           });
  }
  bool counts() const {
    return cells.size() <= 3 && has_numbers(cells.size()) &&
           text.find_first_not_of("0123456789 \t") == std::string_view::npos;
  }
  table::Fault fault(std::string wrong, std::string allowed) const {
    return {number, 1, std::move(wrong), std::move(allowed)};
  }
  /// Whether a unit is the one that ANSYS converts from.
  bool flag(std::size_t place) const {
    if (place < cells.size() && cells[place] != "0" && cells[place] != "1")
      throw fault(fmt::format("'{}' is no flag of units", cells[place]), "0 or 1");
    return place >= cells.size() || cells[place] == "1";
  }
};

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = table::take_line(text);
    if (line.find_first_not_of(" \t") != std::string_view::npos) lines.push_back({number, line});
  }
  return lines;
}

}  // namespace

std::optional<yaml::Node> read_ansys_bearing(std::string_view text, int file) {
  constexpr std::ptrdiff_t most_titles = 3;
  const std::vector<Line> lines = lines_of(text);
  const auto count = std::ranges::find_if(lines, &Line::counts);
  if (lines.end() - count <= std::ptrdiff_t{lines_of_speed} || count - lines.begin() > most_titles) return {};
  for (std::size_t k = 0; k < lines_of_speed; ++k)
    if (!count[static_cast<std::ptrdiff_t>(k) + 1].has_numbers(numbers_of_line[k])) return {};
  const bool in_pounds = count->flag(1), in_rpm = count->flag(2);
  yaml::Node read{yaml::Node::Kind::map, {-1, static_cast<int>(count->number), 1, file}};
  const auto add_columns = [&](std::initializer_list<std::string_view> names, std::string_view unit) {
    for (const std::string_view name : names) {
      read.keys.push_back({fmt::format("{}_{}", name, unit), read.place});
      read.items.push_back({yaml::Node::Kind::list, read.place});
    }
  };
  add_columns({"speed"}, in_rpm ? "rpm" : "rad_per_s");
  add_columns({"kxx", "kxy", "kyx", "kyy"}, in_pounds ? "lbf_per_in" : "n_per_m");
  add_columns({"cxx", "cxy", "cyx", "cyy"}, in_pounds ? "lbf_s_per_in" : "ns_per_m");
  std::size_t found = 0;
  for (auto line = count + 1; line != lines.end(); ++line, ++found) {
    const std::size_t kind = found % lines_of_speed;
    if (!line->has_numbers(numbers_of_line[kind]))
      throw line->fault("is no line of a bearing of ANSYS", fmt::format("{} numbers", numbers_of_line[kind]));
    for (std::size_t k = kind == 0 ? 1 : 0; k < line->cells.size(); ++k) {
      const auto byte = static_cast<int>(line->cells[k].data() - line->text.data()) + 1;
      read.items[kind == 0 ? 0 : 4 * kind - 3 + k].items.push_back(
          {yaml::Node::Kind::scalar,
           {-1, static_cast<int>(line->number), byte, file},
           fmt::format("{}", *table::number_in(line->cells[k], {' '}))});
    }
  }
  if (static_cast<double>(found) / lines_of_speed != *table::number_in(count->cells[0], {' '}))
    throw count->fault(fmt::format("counts {} speeds, and {} lines follow", count->cells[0], found),
                       "three lines for each speed");
  return read;
}

}  // namespace rubsweep::config::machine
