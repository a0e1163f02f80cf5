#include "rubsweep/maps/config/machine/ansys_bearing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::config::machine {
namespace {

struct Line {
  std::size_t number = 0;
  std::string_view text;
  std::vector<std::string_view> cells{};
};

std::optional<double> number_in(std::string_view cell) { return table::number_in(cell, {' ', false}); }

bool are_numbers(const std::vector<std::string_view>& cells, std::size_t count) {
  return cells.size() == count && std::ranges::all_of(cells, [](std::string_view cell) {
           const auto number = number_in(cell);
           return number && std::isfinite(*number);
         });
}

bool are_counts(const std::vector<std::string_view>& cells) {
  return std::ranges::all_of(cells, [](std::string_view cell) {
    return !cell.empty() && cell.find_first_not_of("0123456789") == std::string_view::npos;
  });
}

/// All lines but blank ones at the end.
std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = table::take_line(text);
    lines.push_back({number, line, table::cells_of(line, ' ')});
  }
  while (!lines.empty() && lines.back().text.find_first_not_of(" \t") == std::string_view::npos)
    lines.pop_back();
  return lines;
}

constexpr std::array<std::string_view, 3> meanings{"a number and a speed", "K11, K12, K21 and K22",
                                                   "C11, C12, C21 and C22"};
constexpr std::array<std::size_t, 3> numbers_of_line{2, 4, 4};

/// Index of the line that counts the speeds, below at most three titles; nothing where the text is another
/// one.
std::optional<std::size_t> find_count(const std::vector<Line>& lines) {
  constexpr std::size_t most_titles = 3, most_counts = 3;
  for (std::size_t i = 0; i <= most_titles && i + 3 < lines.size(); ++i) {
    bool begins = lines[i].cells.size() <= most_counts && are_counts(lines[i].cells);
    for (std::size_t k = 0; k < 3; ++k)
      begins = begins && are_numbers(lines[i + 1 + k].cells, numbers_of_line[k]);
    if (begins && are_counts({lines[i + 1].cells[0]})) return i;
  }
  return std::nullopt;
}

/// Whether a unit is the one that ANSYS converts from.
bool flag(const Line& line, std::size_t place) {
  if (place >= line.cells.size()) return true;
  if (line.cells[place] != "0" && line.cells[place] != "1")
    throw table::Fault{line.number, static_cast<std::size_t>(line.cells[place].data() - line.text.data()) + 1,
                       fmt::format("'{}' is no flag of units", line.cells[place]), "0 or 1"};
  return line.cells[place] == "1";
}

}  // namespace

std::optional<yaml::Node> read_ansys_bearing(std::string_view text, int file) {
  const std::vector<Line> lines = lines_of(text);
  const auto at = find_count(lines);
  if (!at) return std::nullopt;
  const Line& count = lines[*at];
  const bool in_pounds = flag(count, 1), in_rpm = flag(count, 2);
  const auto speeds = static_cast<std::size_t>(*number_in(count.cells[0]));
  yaml::Node read{yaml::Node::Kind::map, {-1, static_cast<int>(count.number), 1, file}};
  const auto add_column = [&](std::string name) {
    read.keys.push_back({std::move(name), read.place});
    read.items.push_back({yaml::Node::Kind::list, read.place});
  };
  add_column(in_rpm ? "speed_rpm" : "speed_rad_per_s");
  for (const std::string_view name : {"xx", "xy", "yx", "yy"})
    add_column(fmt::format("k{}_{}", name, in_pounds ? "lbf_per_in" : "n_per_m"));
  for (const std::string_view name : {"xx", "xy", "yx", "yy"})
    add_column(fmt::format("c{}_{}", name, in_pounds ? "lbf_s_per_in" : "ns_per_m"));
  for (std::size_t i = *at + 1; i < lines.size(); ++i) {
    const std::size_t kind = (i - *at - 1) % 3;
    const auto& cells = lines[i].cells;
    if (!are_numbers(cells, numbers_of_line[kind]))
      throw table::Fault{lines[i].number, 1,
                         fmt::format("is no line of a bearing of ANSYS with {}", meanings[kind]),
                         fmt::format("{} numbers", numbers_of_line[kind])};
    for (std::size_t k = kind == 0 ? 1 : 0; k < cells.size(); ++k) {
      const std::size_t column = kind == 0 ? 0 : 4 * (kind - 1) + 1 + k;
      const auto byte = static_cast<int>(cells[k].data() - lines[i].text.data()) + 1;
      read.items[column].items.push_back({yaml::Node::Kind::scalar,
                                          {-1, static_cast<int>(lines[i].number), byte, file},
                                          fmt::format("{}", *number_in(cells[k]))});
    }
  }
  const std::size_t found = lines.size() - *at - 1;
  if (found != 3 * speeds)
    throw table::Fault{count.number, 1,
                       fmt::format("counts {} speeds, and {} lines follow", count.cells[0], found),
                       "three lines for each speed"};
  return read;
}

}  // namespace rubsweep::config::machine
