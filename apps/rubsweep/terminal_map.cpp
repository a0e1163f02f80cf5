#include "terminal_map.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "character_map.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "shell_word.hpp"

namespace rubsweep::apps {
namespace {

/// Speed option in the unit of the configuration, if that gives exactly the same speed; else in Hz.
std::string speed_option(const sweep::Grid& grid, double speed_hz) {
  const auto rpm = sweep::exactly_in_units(grid.written_speed, speed_hz);
  return rpm && grid.written_speed.unit == "rpm" ? fmt::format("--speed-rpm {}", *rpm)
                                                 : fmt::format("--speed-hz {}", batch::csv_number(speed_hz));
}

std::string unbalance_option(const sweep::Grid& grid, const scene::Unbalance& unbalance) {
  return std::visit(
      overloaded{[](const scene::WhirlRatio& ratio) {
                   return fmt::format("--whirl-ratio {}", batch::csv_number(ratio.value));
                 },
                 [&](const scene::Eccentricity& eccentricity) {
                   const auto g_mm = sweep::exactly_in_units(grid.written_unbalance, eccentricity.value_m);
                   return g_mm && grid.written_unbalance.unit == "g mm"
                              ? fmt::format("--unbalance-g-mm {}", *g_mm)
                              : fmt::format("--eccentricity-m {}", batch::csv_number(eccentricity.value_m));
                 }},
      unbalance);
}

std::string rubtrace_command(const std::filesystem::path& directory, const sweep::Grid& grid,
                             std::size_t cell) {
  const scene::Place place = sweep::place_of(grid, cell);
  std::string keys;
  for (const sweep::KeyValue& held : sweep::key_values(grid, cell))
    keys += fmt::format(" --set {}={}", held.key, batch::csv_number(held.value));
  return fmt::format("rubtrace {} {} {}{} --figure cell.png", shell_word(directory / "config.yaml"),
                     speed_option(grid, place.speed_hz), unbalance_option(grid, place.unbalance), keys);
}

/// Reads a map. Returns false where neighbouring characters would not be neighbouring cells, as in a map
/// whose rows were re-sorted; such a map is not shown.
bool read_map(const std::filesystem::path& path, const sweep::Grid& grid, CharacterMap& map) {
  batch::CsvReader rows(path);
  report::CellsOfRows cells(rows, grid);
  bool sorted = true;
  for (std::size_t cell = 0; rows.next(); ++cell) {
    sorted = cells.take(rows) == cell && sorted;
    map.add(batch::csv_row(rows.cells()));
  }
  return sorted && !sweep::disordered_axis(grid);
}

}  // namespace

std::size_t terminal_width() {
  constexpr std::size_t usual = 80, widest = 110;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return std::min<std::size_t>(size.ws_col, widest);
}

bool shows_colours() {
  if (::isatty(STDOUT_FILENO) == 0) return false;
  const char *none = std::getenv("NO_COLOR"), *colours = std::getenv("COLORTERM");
  const std::string_view named = colours == nullptr ? "" : colours;
  return (none == nullptr || *none == '\0') && (named == "truecolor" || named == "24bit");
}

std::string map_in_characters(const std::filesystem::path& path, const sweep::Grid& grid) {
  CharacterMap map(grid);
  return read_map(path, grid, map) ? map.text(terminal_width(), shows_colours()) : "";
}

TerminalView terminal_view(const std::filesystem::path& path, const sweep::Grid& grid, bool has_report) {
  if (::isatty(STDOUT_FILENO) == 0) return {};
  CharacterMap map(grid);
  const bool in_order = read_map(path, grid, map);
  TerminalView view{in_order ? map.text(terminal_width(), shows_colours()) : "", {}};
  if (in_order && view.map.empty()) return view;
  if (const auto cell = map.typical_rub()) {
    view.next +=
        fmt::format("next: {}  # {}\n", rubtrace_command(path.parent_path(), grid, *cell), map.name(*cell));
  }
  if (!has_report) view.next += fmt::format("next: rubreport {}\n", shell_word(path.parent_path()));
  return view;
}

}  // namespace rubsweep::apps
