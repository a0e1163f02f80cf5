#include "rubsweep/report/comparison_figure.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace rubsweep::report {
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

std::string data_of(const MapComparison& comparison, CellVerdict verdict) {
  std::string data;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.verdict == verdict) data += fmt::format("{} {}\n", cell.speed_hz, cell.unbalance);
  }
  return data;
}

/// Text between single quotes, where gnuplot knows one escape.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

}  // namespace

std::string comparison_figure(const MapComparison& comparison, const std::string& heading,
                              const std::string& terminal, const std::string& output) {
  std::string script, plots;
  for (const Style& style : styles) {
    const std::size_t cells = comparison.count(style.verdict);
    if (cells == 0) continue;
    const auto block = fmt::format("$cells_{}", static_cast<int>(style.verdict));
    script += fmt::format("{} << END\n{}END\n", block, data_of(comparison, style.verdict));
    plots += fmt::format("{}{} with points pointtype 5 pointsize 1 linecolor rgb '{}' title '{} ({})'",
                         plots.empty() ? "" : ", \\\n     ", block, style.colour, style.name, cells);
  }
  return fmt::format(
      "set terminal {} size 1000,600 noenhanced font 'DejaVu Sans,11'\n"
      "set output {}\n"
      "set title {}\n"
      "set xlabel 'shaft speed (Hz)'\n"
      "set ylabel '{}'\n"
      "set key outside below\n"
      "set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05\n"
      "{}plot {}\n",
      terminal, in_quotes(output), in_quotes(heading),
      comparison.axis == "whirl_ratio" ? "whirl ratio before contact" : "eccentricity (m)", script, plots);
}

}  // namespace rubsweep::report
