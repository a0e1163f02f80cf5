#include "rubsweep/report/comparison_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "rubsweep/error.hpp"

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

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Text between single quotes, where gnuplot knows one escape. A line would end there, and with it the
/// string.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, is_control(c) ? '?' : c);
  return result + "'";
}

/// Gnuplot takes a name that begins with '|' for a command, and one with '~' for somebody's home.
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
      "{}"
      "set title {}\n"
      "set xlabel 'shaft speed (Hz)'\n"
      "set ylabel '{}'\n"
      "set key outside below\n"
      "set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05\n"
      "{}plot {}\n",
      terminal, set_output(output), in_quotes(heading),
      comparison.axis == "whirl_ratio" ? "whirl ratio before contact" : "eccentricity (m)", script, plots);
}

}  // namespace rubsweep::report
