#include "rubsweep/maps/report/unit_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <functional>

#include "rubsweep/maps/report/map_columns.hpp"

namespace rubsweep::report {
namespace {

struct UnitColumn {
  std::string_view name, description;
};
/// In the order of the file.
constexpr std::array unit_columns{
    UnitColumn{"speed_rpm", "shaft speed in revolutions per minute"},
    UnitColumn{"unbalance_g_mm", "unbalance of the rotor in g mm"},
    UnitColumn{"balance_grade_mm_per_s", "balance quality grade at the rated speed, in mm/s"},
};

/// The number in the column called `name` of a row.
using CellOf = std::function<double(std::string_view name)>;

std::string cells_by(const CellOf& cell, const sweep::Grid& grid) {
  std::string text;
  if (!grid.written_speed.is_si())
    text.append(",").append(sweep::in_units(grid.written_speed, cell("speed_hz")));
  if (!grid.written_unbalance.is_si())
    text.append(",").append(sweep::in_units(grid.written_unbalance, cell("eccentricity_m")));
  return text;
}

}  // namespace

std::string unit_header(const sweep::Grid& grid) {
  std::string names;
  for (const auto* axis : {&grid.written_speed, &grid.written_unbalance}) {
    if (!axis->is_si()) names += "," + axis->key;
  }
  return names;
}

std::string unit_cells(const sweep::Row& row, const sweep::Grid& grid) {
  return cells_by(
      [&](std::string_view name) { return name == "speed_hz" ? row.speed_hz : row.eccentricity_m; }, grid);
}

std::string unit_cells(std::string_view map_line, const sweep::Grid& grid) {
  return cells_by(
      [&](std::string_view name) {
        std::string_view rest = map_line;
        for (std::size_t column = place_of_column(name); column > 0; --column)
          rest.remove_prefix(rest.find(',') + 1);
        double value = 0;
        std::from_chars(rest.data(), rest.data() + rest.size(), value);
        return value;
      },
      grid);
}

std::string_view without_unit_columns(std::string_view header) {
  for (bool found = true; found;) {
    found = false;
    for (const UnitColumn& column : unit_columns) {
      if (!header.ends_with(fmt::format(",{}", column.name))) continue;
      header.remove_suffix(column.name.size() + 1);
      found = true;
    }
  }
  return header;
}

std::string describe_unit_columns() {
  std::string text = "Columns behind all others where the sweep is written in these units:\n";
  for (const UnitColumn& column : unit_columns)
    text += fmt::format("  {:<23}  {}\n", column.name, column.description);
  return text;
}

}  // namespace rubsweep::report
