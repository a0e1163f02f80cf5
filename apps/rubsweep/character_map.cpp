#include "character_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/report/map_summary.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::size_t most_rows = 20, label_width = 14;

/// Kind of the cells that are not computed yet.
constexpr response::motion::MotionKind unfinished{"unfinished", "unfinished", 0, 0, ' ', false, false};

/// A character of the map, and the kind of motion that it stands for.
struct Sign {
  char character;
  const response::motion::MotionKind* kind;
};

/// Character of a motion; subharmonic motions of up to nine turns show their order.
Sign sign_of(std::string_view name, const response::motion::MotionKind& kind) {
  constexpr std::string_view subharmonic = "subharmonic 1/";
  if (!name.starts_with(subharmonic)) return {kind.sign, &kind};
  const std::string_view digits = name.substr(subharmonic.size());
  return {digits.size() == 1 ? digits.front() : '+', &kind};
}

/// A character on the background colour of its kind, black or white for best contrast.
std::string shown(const Sign& sign, bool coloured) {
  if (!coloured || sign.kind == &unfinished) return std::string(1, sign.character);
  const std::uint32_t rgb = sign.kind->colour;
  const auto red = rgb >> 16U & 0xFFU, green = rgb >> 8U & 0xFFU, blue = rgb & 0xFFU;
  const bool light = 299 * red + 587 * green + 114 * blue > 140'000;
  return fmt::format("\x1b[48;2;{};{};{}m\x1b[38;5;{}m{}\x1b[0m", red, green, blue, light ? 16 : 231,
                     sign.character);
}

/// Meanings of the characters in use, sorted by character; all periods above nine turns share an entry.
std::vector<std::pair<std::string, Sign>> legend_of(
    const std::vector<std::string>& names, const std::vector<const response::motion::MotionKind*>& kinds) {
  std::vector<std::pair<std::string, Sign>> legend;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    if (kinds[i] == &unfinished) continue;
    const Sign sign = sign_of(name, *kinds[i]);
    const std::string meaning = sign.character == '+' ? "subharmonic of more than 9 turns" : name;
    const bool known = std::ranges::any_of(legend, [&](const auto& entry) { return entry.first == meaning; });
    if (!known) legend.emplace_back(meaning, sign);
  }
  std::ranges::stable_sort(legend, {}, [](const auto& entry) { return entry.second.character; });
  return legend;
}

std::string label_of(const sweep::WrittenAxis& axis, double si) {
  return fmt::format("{:.4g}", si * axis.units_per_si);
}

/// Label at an end of the speed axis: Hz and rpm, or the unit in which the axis was written.
std::string speed_label(const sweep::WrittenAxis& axis, double speed_hz) {
  return axis.is_si() ? model::speed_text(speed_hz, 4) : label_of(axis, speed_hz) + " " + axis.unit;
}

/// Name of the unbalance, short enough for the column of labels.
std::string name_of_unbalance(const sweep::Grid& grid) {
  if (grid.written_unbalance.is_si()) return std::string(to_string(grid.measure));
  return grid.written_unbalance.unit == "mm/s" ? "grade, mm/s" : "unbalance g mm";
}

/// Text line that names the logarithmic axes; empty where there are none.
std::string scales_of(const sweep::Grid& grid) {
  const auto is_log = [](const sweep::WrittenAxis& axis) {
    return axis.spacing && axis.spacing->logarithmic;
  };
  std::string names;
  if (is_log(grid.written_speed)) names = "speed";
  if (is_log(grid.written_unbalance)) names += names.empty() ? "unbalance" : " and unbalance";
  return names.empty() ? "" : fmt::format("{:>{}} logarithmic: {}\n", "", label_width, names);
}

/// Index of the middle value in part `i` of `parts` equal parts of a range.
std::size_t middle_of(std::size_t i, std::size_t parts, std::size_t values) {
  return (2 * i + 1) * values / (2 * parts);
}

}  // namespace

void CharacterMap::add(std::string_view map_line) {
  add(report::motion_name(map_line), report::kind_in(map_line));
}

void CharacterMap::add_unfinished() { add("unfinished", unfinished); }

void CharacterMap::add(const std::string& name, const response::motion::MotionKind& kind) {
  const auto known = std::ranges::find(names_, name);
  cells_.push_back(static_cast<std::uint16_t>(known - names_.begin()));
  if (known != names_.end()) return;
  names_.push_back(name);
  kinds_.push_back(&kind);
}

std::string CharacterMap::text(std::size_t width, bool coloured) const {
  const std::size_t speeds = grid_.speed_hz.size(), unbalances = grid_.unbalance.size();
  if (cells_.size() != speeds * unbalances || cells_.empty()) return "";
  const std::size_t room = std::max<std::size_t>(width, label_width + 20) - label_width - 1;
  const std::size_t columns = std::min(speeds, room), rows = std::min(unbalances, most_rows);
  std::string text, legend;
  const auto sign_at = [this](std::size_t cell) {
    return sign_of(names_[cells_[cell]], *kinds_[cells_[cell]]);
  };
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t row = middle_of(rows - 1 - i, rows, unbalances);
    const bool at_end = i == 0 || i == rows - 1;
    text += fmt::format("{:>{}} ", at_end ? label_of(grid_.written_unbalance, grid_.unbalance[row]) : "",
                        label_width);
    for (std::size_t k = 0; k < columns; ++k)
      text += shown(sign_at(row * speeds + middle_of(k, columns, speeds)), coloured);
    text += '\n';
  }
  const std::string from = speed_label(grid_.written_speed, grid_.speed_hz.front()),
                    to = speed_label(grid_.written_speed, grid_.speed_hz.back());
  const std::size_t between = columns > from.size() + to.size() ? columns - from.size() - to.size() : 1;
  text += fmt::format("{:>{}} {}{:{}}{}\n", name_of_unbalance(grid_), label_width, from, "", between, to);
  text += scales_of(grid_);
  std::size_t used = 0;
  for (const auto& [name, sign] : legend_of(names_, kinds_)) {
    const std::size_t size = name.size() + 4;
    if (used + size > width && used > 0) {
      legend += '\n';
      used = 0;
    }
    used += size;
    legend += fmt::format("  {} {}", shown(sign, coloured), name);
  }
  return text + legend + '\n';
}

std::optional<std::size_t> CharacterMap::typical_rub() const {
  struct Count {
    std::size_t cells = 0, column = 0, row = 0;
  };
  const std::size_t speeds = grid_.speed_hz.size();
  std::vector<Count> counts(names_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Count& count = counts[cells_[i]];
    ++count.cells;
    count.column += i % speeds;
    count.row += i / speeds;
  }
  std::optional<std::size_t> most;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (!kinds_[k]->settled_rub) continue;
    if (!most || counts[k].cells > counts[*most].cells) most = k;
  }
  if (!most) return std::nullopt;
  const Count& count = counts[*most];
  const auto mean = [&](std::size_t sum) {
    return static_cast<double>(sum) / static_cast<double>(count.cells);
  };
  const auto distance = [&](std::size_t cell) {
    // Distances are relative to the size of the map, so that a long axis does not dominate.
    return std::hypot(
        (static_cast<double>(cell % speeds) - mean(count.column)) / static_cast<double>(speeds),
        (static_cast<double>(cell / speeds) - mean(count.row)) / static_cast<double>(grid_.unbalance.size()));
  };
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] == *most && (!nearest || distance(i) < distance(*nearest))) nearest = i;
  }
  return nearest;
}

}  // namespace rubsweep::apps
