#include "rubsweep/analysis/page/painted_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::page {
namespace {

/// A column of an axis of the grid, and its text at each value of the axis.
struct AxisColumn {
  std::string name;
  std::vector<double> values;
  std::size_t stride = 1;  ///< cells from one place to the next

  std::size_t place_in(std::size_t cell) const { return cell / stride % values.size(); }
};

/// Speed, unbalance, and the keys of every axis; the first column of an axis tells its place.
std::vector<std::vector<AxisColumn>> axes_of(const sweep::Grid& grid) {
  std::vector<std::vector<AxisColumn>> axes{{{"speed_hz", grid.speed_hz, 1}}};
  std::size_t stride = grid.speed_hz.size();
  axes.push_back({{std::string(to_string(grid.measure)), grid.unbalance, stride}});
  stride *= grid.unbalance.size();
  for (const sweep::KeyAxis& axis : grid.axes) {
    std::vector<AxisColumn> columns;
    for (std::size_t key = 0; key < axis.keys.size(); ++key) {
      columns.push_back({axis.keys[key], {}, stride});
      for (const double value : axis.values)
        columns.back().values.push_back(sweep::keys_at(axis, value)[key].value);
    }
    axes.push_back(std::move(columns));
    stride *= axis.values.size();
  }
  return axes;
}

std::size_t cell_of(const MapTable& map, std::size_t row, const std::vector<std::vector<AxisColumn>>& axes) {
  std::size_t cell = 0;
  for (const auto& columns : axes) {
    // A factor of 0 tells nothing of the place.
    const auto telling = std::ranges::find_if(columns, [](const AxisColumn& column) {
      return column.values.size() == 1 || column.values[0] != column.values[1];
    });
    const AxisColumn& column = telling == columns.end() ? columns.front() : *telling;
    const auto value = map.number(column.name, row);
    const auto found = std::ranges::find(column.values, value.value_or(std::nan("")));
    if (found == column.values.end())
      throw IoError(
          fmt::format("map.csv: its row {} is no cell of its configuration by {}", row + 1, column.name));
    cell += static_cast<std::size_t>(found - column.values.begin()) * column.stride;
  }
  return cell;
}

}  // namespace

PaintedTable painted_table(const MapTable& map, const sweep::Grid& grid) {
  const auto axes = axes_of(grid);
  const std::size_t cells = sweep::cell_count(grid);
  PaintedTable table{{map.version, map.digest, cells, {}}, {}, std::vector<int>(cells, sweep::unknown_label)};
  std::vector<std::size_t> row_of(cells, map.rows);
  std::map<std::pair<std::string_view, double>, int> numbers;
  for (std::size_t row = 0; row < map.rows; ++row) {
    const std::size_t cell = cell_of(map, row, axes);
    const std::pair name(map.word("class", row), map.number("order", row).value_or(0));
    table.labels[cell] = numbers.try_emplace(name, static_cast<int>(numbers.size())).first->second;
    row_of[cell] = row;
    table.computed.push_back(cell);
  }
  if (const auto wanted = sweep::wanted_cells(grid, table.labels); !wanted.empty())
    throw IoError(fmt::format("map.csv: lacks {} cells that its refined map wants", wanted.size()));
  std::ranges::sort(table.computed);
  const std::vector<std::size_t> shown = sweep::shown_cells(grid, table.labels);

  constexpr std::array<std::string_view, 5> of_the_block{"class", "order", "orbit", "whirl", "comb_spacing"};
  for (const MapColumn& column : map.columns) {
    const bool of_block = std::ranges::find(of_the_block, column.name) != of_the_block.end();
    const AxisColumn* axis = nullptr;
    for (const auto& columns : axes) {
      for (const AxisColumn& own : columns) axis = own.name == column.name ? &own : axis;
    }
    MapColumn& whole = table.map.columns.emplace_back(MapColumn{column.name, {}, {}});
    for (std::size_t cell = 0; cell < cells; ++cell) {
      const bool known = row_of[cell] < map.rows;
      const std::size_t row = row_of[shown[cell]];
      if (!column.numbers.empty()) {
        const double empty = std::numeric_limits<double>::quiet_NaN();
        whole.numbers.push_back(axis != nullptr     ? axis->values[axis->place_in(cell)]
                                : known || of_block ? column.numbers[row]
                                                    : empty);
      } else {
        whole.words.push_back(known || of_block         ? column.words[row]
                              : column.name == "status" ? std::string(not_computed)
                                                        : std::string());
      }
    }
  }
  return table;
}

}  // namespace rubsweep::page
