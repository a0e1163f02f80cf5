#include "comparison_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::apps {
namespace {

struct Style {
  CellVerdict verdict;
  std::string_view name, colour;
};

constexpr std::array styles{Style{CellVerdict::equal, "equal", "#d9d9d9"},
                            Style{CellVerdict::sensitive, "sensitive, not compared", "#9ecae1"},
                            Style{CellVerdict::numbers_differ, "other numbers", "#fdae61"},
                            Style{CellVerdict::classes_differ, "another class", "#d7191c"},
                            Style{CellVerdict::only_in_one, "in one map only", "#000000"}};

/// A coordinate of the cells that may become an axis of the picture.
struct Axis {
  std::string column;
  std::vector<double> values;     ///< one value per cell, in the order of the cells
  std::vector<double> different;  ///< distinct values, ascending
};

Axis axis_of(std::string column, const MapComparison& comparison, const auto& value_of) {
  Axis axis{std::move(column), {}, {}};
  for (const ComparedCell& cell : comparison.cells) axis.values.push_back(value_of(cell));
  axis.different = axis.values;
  std::sort(axis.different.begin(), axis.different.end());
  axis.different.erase(std::unique(axis.different.begin(), axis.different.end()), axis.different.end());
  return axis;
}

/// The first two axes with several values; speed and unbalance where there are fewer than two.
std::array<Axis, 2> plane_of(const MapComparison& comparison) {
  std::vector<Axis> axes;
  axes.push_back(axis_of("speed_hz", comparison, [](const ComparedCell& cell) { return cell.speed_hz; }));
  axes.push_back(
      axis_of(comparison.axis, comparison, [](const ComparedCell& cell) { return cell.unbalance; }));
  for (std::size_t i = 0; i < comparison.keys.size(); ++i)
    axes.push_back(
        axis_of(comparison.keys[i], comparison, [i](const ComparedCell& cell) { return cell.keys.at(i); }));
  std::stable_partition(axes.begin(), axes.end(), [](const Axis& axis) { return axis.different.size() > 1; });
  return {axes[0], axes[1]};
}

/// Edges of the cell at a value: midpoints to the neighbouring values.
std::array<double, 2> edges(const std::vector<double>& values, double value) {
  const auto at = static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
  if (values.size() == 1) return {value - 0.5, value + 0.5};
  const double before = at > 0 ? value - values[at - 1] : values[1] - value,
               after = at + 1 < values.size() ? values[at + 1] - value : before;
  return {value - before / 2, value + after / 2};
}

std::string data_of(const MapComparison& comparison, const std::array<Axis, 2>& plane, CellVerdict verdict) {
  std::string data;
  for (std::size_t i = 0; i < comparison.cells.size(); ++i) {
    if (comparison.cells[i].verdict != verdict) continue;
    const double x = plane[0].values[i], y = plane[1].values[i];
    const auto across = edges(plane[0].different, x), up = edges(plane[1].different, y);
    data += fmt::format("{} {} {} {} {} {}\n", x, y, across[0], across[1], up[0], up[1]);
  }
  return data;
}

std::string label_of(const std::string& column) {
  if (column == "speed_hz") return "shaft speed (Hz)";
  if (column == "whirl_ratio") return "whirl ratio (quiet whirl / clearance)";
  if (column == "eccentricity_m") return "eccentricity (m)";
  return column;
}

/// Gnuplot commands for an rpm scale above an axis of speeds in Hz; empty for other axes.
std::string_view rpm_above(const std::string& column) {
  if (column != "speed_hz") return "";
  return "set link x2 via 60 * x inverse x / 60.0\n"
         "set x2tics out nomirror format '%g' font ',13'\n"
         "set label 3 'rpm' at graph 0, graph 1 right offset character -2.5, 1.5 font ',13'\n";
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Text in single quotes with gnuplot's only escape there. A line break would end the string, so it is
/// replaced.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, is_control(c) ? '?' : c);
  return result + "'";
}

/// Gnuplot takes a name that begins with '|' or '<' for a command, and one with '~' for a home directory.
std::string set_output(const std::string& output) {
  if (output.empty()) return "";
  if (std::ranges::any_of(output, is_control)) {
    throw IoError(fmt::format("cannot write {}: its name has control characters", in_quotes(output)));
  }
  const bool is_special = std::string_view("|<~").find(output.front()) != std::string_view::npos;
  return fmt::format("set output {}\n", in_quotes((is_special ? "./" : "") + output));
}

}  // namespace

std::string comparison_figure(const MapComparison& comparison, const std::string& heading,
                              const std::string& terminal, const std::string& output) {
  const std::array<Axis, 2> plane = plane_of(comparison);
  std::string script, plots;
  // The worst results come last, so that they stay visible where cells overlap.
  for (const Style& style : styles) {
    const std::size_t cells = comparison.count(style.verdict);
    if (cells == 0) continue;
    const auto block = fmt::format("$cells_{}", static_cast<int>(style.verdict));
    script += fmt::format("{} << END\n{}END\n", block, data_of(comparison, plane, style.verdict));
    plots += fmt::format(
        "{}{} using 1:2:3:4:5:6 with boxxyerror linecolor rgb '{}' linewidth 0.5 fillstyle solid 1 border "
        "title "
        "'{} ({})'",
        plots.empty() ? "" : ", \\\n     ", block, style.colour, style.name, cells);
  }
  return fmt::format(
      "set terminal {} size 1300,800 noenhanced font 'DejaVu Sans,15' linewidth 1.2\n"
      "{}"
      "set encoding utf8\n"
      "set label 1 {} at screen 0.5, 0.965 center font ':Bold,17'\n"
      "set label 2 {} at screen 0.5, 0.925 center font ',12'\n"
      "set xlabel {}\n"
      "set ylabel {}\n"
      "set tics out nomirror\n"
      "{}"
      "set tmargin at screen 0.85\n"
      "set rmargin at screen 0.74\n"
      "set key at screen 0.755, graph 1 left top Left reverse samplen 1.5 spacing 1.4\n"
      "set autoscale noextend\n"
      "{}plot {}\n",
      terminal, set_output(output),
      in_quotes(comparison.equal() ? "Two maps that are equal" : "Where two maps differ"), in_quotes(heading),
      in_quotes(label_of(plane[0].column)), in_quotes(label_of(plane[1].column)), rpm_above(plane[0].column),
      script, plots);
}

}  // namespace rubsweep::apps
