#include "compare_maps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

using batch::CsvReader;
using report::CellKey, report::CellPlace, report::Comparison, report::MapColumn;

ComparedCell cell_of(const CellKey& key, CellVerdict verdict, std::string label_a, std::string label_b) {
  return {key[0], key[1], {key.begin() + 2, key.end()}, verdict, std::move(label_a), std::move(label_b)};
}

bool has(const CsvReader& map, std::string_view column) {
  return std::ranges::find(map.header(), column) != map.header().end();
}

/// Text in a column of the current row.
const std::string& text(const CsvReader& row, std::string_view name) { return row.cells()[row.column(name)]; }

std::string label(const CsvReader& row) {
  const std::string &name = text(row, "class"), &order = text(row, "order");
  return order.empty() || order == "1" ? name : fmt::format("{} 1/{}", name, order);
}

/// Whether a motion repeats, so that its numbers do not depend on the time of observation.
bool repeats(const CsvReader& row) {
  const auto motion_class = response::motion::motion_class_of(text(row, "class"));
  return motion_class && row_of(*motion_class).repeats;
}

/// Rows of both maps for one cell, with access to their columns.
struct Pair {
  const CsvReader &a, &b;

  static double number(const CsvReader& row, std::string_view name) { return row.number(row.column(name)); }

  /// Relative difference of a number; empty where both cells are empty or equal to the last bit.
  std::optional<double> relative_difference(const MapColumn& column) const {
    const double x = number(a, column.name), y = number(b, column.name);
    if (x == y) return std::nullopt;
    double scale = std::max(std::abs(x), std::abs(y));
    if (column.unit == "m") {
      const double peak_m = number(a, "peak_displacement_m");
      if (peak_m > scale) scale = peak_m;
    }
    return std::abs(x - y) / scale;
  }
};

/// Counts, for each column, the cells that differ, and keeps the largest difference.
class Columns {
 public:
  void add(std::string_view column, std::size_t cell, std::optional<double> size, const Pair& pair) {
    ColumnDifference& worst = found_[std::string(column)];
    ++worst.cells;
    if (worst.cells > 1 && (!worst.largest || (size && *size <= *worst.largest))) return;
    worst.largest = size;
    worst.cell = cell;
    worst.a = text(pair.a, column);
    worst.b = text(pair.b, column);
  }

  std::vector<ColumnDifference> list() const {
    std::vector<ColumnDifference> list;
    for (const auto& [name, difference] : found_) {
      list.push_back(difference);
      list.back().column = name;
    }
    return list;
  }

 private:
  std::map<std::string, ColumnDifference> found_;
};

bool is_compared(const MapColumn& column) {
  return column.comparison == Comparison::text || column.comparison == Comparison::number;
}

/// Compares the columns of a cell; returns whether any differs.
bool compare_columns(const Pair& pair, const std::vector<MapColumn>& compared, std::size_t cell,
                     double tolerance, Columns& columns) {
  bool differs = false;
  const auto found = [&](std::string_view column, std::optional<double> size) {
    columns.add(column, cell, size, pair);
    differs = true;
  };
  for (const MapColumn& column : compared) {
    const std::string &in_a = text(pair.a, column.name), &in_b = text(pair.b, column.name);
    if (column.comparison == Comparison::text || in_a.empty() || in_b.empty()) {
      if (in_a != in_b) found(column.name, std::nullopt);
      continue;
    }
    const auto size = pair.relative_difference(column);
    if (size && !(*size <= tolerance)) found(column.name, size);
  }
  return differs;
}

}  // namespace

std::size_t MapComparison::count(CellVerdict verdict) const {
  return static_cast<std::size_t>(std::ranges::count(cells, verdict, &ComparedCell::verdict));
}

bool MapComparison::equal() const {
  return count(CellVerdict::equal) + count(CellVerdict::sensitive) == cells.size();
}

MapComparison compare_maps(const fs::path& path_a, const fs::path& path_b, double tolerance,
                           const std::optional<fs::path>& sensitive) {
  CsvReader a(path_a), b(path_b);
  MapComparison comparison;
  comparison.axis = report::second_axis(path_a, path_b);
  comparison.keys = report::keys_of(a);
  if (comparison.keys != report::keys_of(b)) {
    throw IoError(fmt::format("{}: is swept over other keys than {}: '{}' and '{}'", path_b.string(),
                              path_a.string(), fmt::join(report::keys_of(b), ","),
                              fmt::join(comparison.keys, ",")));
  }
  comparison.digest_a = report::comment_after(a, "digest ");
  comparison.digest_b = report::comment_after(b, "digest ");
  report::rows_by_cell(path_a, comparison.axis, comparison.keys);  // throws where a cell occurs twice
  const auto rows_b = report::rows_by_cell(path_b, comparison.axis, comparison.keys);
  const auto left_out = sensitive ? report::rows_by_cell(*sensitive, comparison.axis, comparison.keys)
                                  : std::vector<CellPlace>{};
  const std::vector<std::size_t> columns_a = report::key_columns(a, comparison.axis, comparison.keys);

  // A map of an earlier version lacks columns that were added later; these are not compared.
  std::vector<MapColumn> compared;
  for (const MapColumn& column : report::map_columns()) {
    if (!is_compared(column)) continue;
    const bool in_a = has(a, column.name), in_b = has(b, column.name);
    if (in_a && in_b) compared.push_back(column);
    if (in_a != in_b) comparison.missing_columns.emplace_back(column.name);
  }
  Columns columns;
  std::vector<bool> met(rows_b.size(), false);
  while (a.next()) {
    const CellKey key = report::key_of(a, columns_a);
    ComparedCell cell = cell_of(key, CellVerdict::equal, label(a), "");
    const auto found = report::find_cell(rows_b, key);
    if (!found) {
      cell.verdict = CellVerdict::only_in_one;
    } else {
      met[*found] = true;
      b.read_at(rows_b[*found].row);
      cell.label_b = label(b);
      const bool fragile = text(a, "robust") == "no" || text(b, "robust") == "no";
      if (fragile || report::find_cell(left_out, key)) {
        cell.verdict = CellVerdict::sensitive;
      } else if (cell.label_a != cell.label_b) {
        cell.verdict = CellVerdict::classes_differ;
      } else if (repeats(a) &&
                 compare_columns({a, b}, compared, comparison.cells.size(), tolerance, columns)) {
        cell.verdict = CellVerdict::numbers_differ;
      }
    }
    comparison.cells.push_back(std::move(cell));
  }
  for (std::size_t i = 0; i < rows_b.size(); ++i) {
    if (met[i]) continue;
    b.read_at(rows_b[i].row);
    comparison.cells.push_back(cell_of(rows_b[i].key, CellVerdict::only_in_one, "", label(b)));
  }
  comparison.columns = columns.list();
  return comparison;
}

}  // namespace rubsweep::apps
