#include "rubsweep/report/compare_maps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/map_columns.hpp"
#include "rubsweep/response/motion/motion_class.hpp"

namespace rubsweep::report {
namespace {

namespace fs = std::filesystem;

using batch::CsvReader;
using Key = std::vector<double>;  ///< speed, unbalance, then the axes over keys

/// The axis holds few values that come again and again; the other measure follows from it.
std::string second_axis(const fs::path& map) {
  CsvReader rows(map);
  const auto distinct = [](std::vector<double>& values) {
    std::ranges::sort(values);
    return std::unique(values.begin(), values.end()) - values.begin();
  };
  const std::size_t eccentricity = rows.column("eccentricity_m"), ratio = rows.column("whirl_ratio");
  std::vector<double> eccentricities, ratios;
  while (rows.next()) {
    // What does not apply counts as one value.
    for (auto& [column, values] : {std::pair(eccentricity, &eccentricities), {ratio, &ratios}}) {
      const double value = rows.number(column);
      values->push_back(std::isnan(value) ? -1 : value);
    }
  }
  return distinct(eccentricities) < distinct(ratios) ? "eccentricity_m" : "whirl_ratio";
}

/// Where the row of a cell is.
struct CellPlace {
  Key key;
  CsvReader::Place row;
};

/// What follows `mark` in the comments of a map; empty where nothing does.
std::string comment(const CsvReader& map, std::string_view mark) {
  for (const std::string& comment : map.comments()) {
    if (comment.starts_with(mark)) return comment.substr(mark.size());
  }
  return "";
}

/// The columns of the axes over keys, which hold no comma.
std::vector<std::string> keys_of(const CsvReader& map) {
  std::vector<std::string> keys;
  std::istringstream names(comment(map, "keys "));
  for (std::string name; std::getline(names, name, ',');) keys.push_back(name);
  return keys;
}

/// The columns that say which cell a row is.
std::vector<std::size_t> key_columns(const CsvReader& map, const std::string& axis,
                                     const std::vector<std::string>& keys) {
  std::vector<std::size_t> columns{map.column("speed_hz"), map.column(axis)};
  for (const std::string& key : keys) columns.push_back(map.column(key));
  return columns;
}

Key key_of(const CsvReader& row, const std::vector<std::size_t>& columns) {
  Key key;
  for (const std::size_t column : columns) key.push_back(row.number(column));
  return key;
}

ComparedCell cell_of(const Key& key, CellVerdict verdict, std::string label_a, std::string label_b) {
  return {key[0], key[1], {key.begin() + 2, key.end()}, verdict, std::move(label_a), std::move(label_b)};
}

/// The rows of a map, in the order of their cells.
std::vector<CellPlace> rows_by_cell(const fs::path& map, const std::string& axis,
                                    const std::vector<std::string>& keys) {
  CsvReader rows(map);
  const std::vector<std::size_t> columns = key_columns(rows, axis, keys);
  std::vector<CellPlace> places;
  while (rows.next()) places.push_back({key_of(rows, columns), rows.place()});
  // Rows of one cell stay in the order of the file.
  std::ranges::stable_sort(places, {}, &CellPlace::key);
  const auto twice = std::ranges::adjacent_find(places, {}, &CellPlace::key);
  if (twice != places.end()) {
    throw IoError(fmt::format("{}:{}: this cell is in the map twice", map.string(), (twice + 1)->row.line));
  }
  return places;
}

/// None where there is no such cell.
std::optional<std::size_t> find_cell(const std::vector<CellPlace>& places, const Key& key) {
  const auto place = std::ranges::lower_bound(places, key, {}, &CellPlace::key);
  if (place == places.end() || place->key != key) return std::nullopt;
  return static_cast<std::size_t>(place - places.begin());
}

bool has(const CsvReader& map, std::string_view column) {
  return std::ranges::find(map.header(), column) != map.header().end();
}

/// Of the row that was read last.
const std::string& text(const CsvReader& row, std::string_view name) { return row.cells()[row.column(name)]; }

std::string label(const CsvReader& row) {
  const std::string &name = text(row, "class"), &order = text(row, "order");
  return order.empty() || order == "1" ? name : fmt::format("{} 1/{}", name, order);
}

/// Motions whose numbers do not depend on when one looks.
bool repeats(const CsvReader& row) {
  using response::motion::motion_classes, response::motion::MotionClass;
  const std::string& name = text(row, "class");
  return std::ranges::any_of(motion_classes, [&](MotionClass motion_class) {
    return row_of(motion_class).repeats && row_of(motion_class).word == name;
  });
}

/// A pair of rows for one cell, and what their columns say.
struct Pair {
  const CsvReader &a, &b;

  static double number(const CsvReader& row, std::string_view name) { return row.number(row.column(name)); }

  /// Empty when both are empty or equal to the last bit.
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

/// Collects, for each column, in how many cells it differs and where most.
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

/// True when something differs.
bool compare_columns(const Pair& pair, std::size_t cell, double tolerance, Columns& columns) {
  bool differs = false;
  const auto found = [&](std::string_view column, std::optional<double> size) {
    columns.add(column, cell, size, pair);
    differs = true;
  };
  for (const MapColumn& column : map_columns()) {
    // A map of an earlier version ends before the columns that were added since.
    if (!is_compared(column) || !has(pair.a, column.name) || !has(pair.b, column.name)) continue;
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

std::string place(const MapComparison& comparison, const ComparedCell& cell) {
  std::string text = fmt::format("speed_hz {}, {} {}", cell.speed_hz, comparison.axis, cell.unbalance);
  for (std::size_t i = 0; i < cell.keys.size(); ++i)
    text += fmt::format(", {} {}", comparison.keys[i], cell.keys[i]);
  return text;
}

/// The cells of a kind, the first twenty by name.
std::string list_cells(const MapComparison& comparison, CellVerdict verdict) {
  constexpr std::size_t longest = 20;
  std::string text;
  std::size_t listed = 0;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.verdict != verdict || ++listed > longest) continue;
    const auto shown = [](const std::string& label) { return label.empty() ? "no such cell" : label; };
    text +=
        fmt::format("  {}: {} -> {}\n", place(comparison, cell), shown(cell.label_a), shown(cell.label_b));
  }
  if (listed > longest) text += fmt::format("  ... and {} more\n", listed - longest);
  return text;
}

std::string list_columns(const MapComparison& comparison) {
  std::string text;
  for (const ColumnDifference& column : comparison.columns) {
    const std::string size = column.largest ? fmt::format("largest {:.2g}", *column.largest) : "first";
    text += fmt::format("  {}: {} cells, {} at {}: {} -> {}\n", column.column, column.cells, size,
                        place(comparison, comparison.cells[column.cell]),
                        column.a.empty() ? "empty" : column.a, column.b.empty() ? "empty" : column.b);
  }
  return text;
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
  comparison.axis = second_axis(path_a);
  comparison.keys = keys_of(a);
  if (comparison.keys != keys_of(b)) {
    throw IoError(fmt::format("{}: is swept over other keys than {}: '{}' and '{}'", path_b.string(),
                              path_a.string(), comment(b, "keys "), comment(a, "keys ")));
  }
  comparison.digest_a = comment(a, "digest ");
  comparison.digest_b = comment(b, "digest ");
  rows_by_cell(path_a, comparison.axis, comparison.keys);  // no cell twice
  const auto rows_b = rows_by_cell(path_b, comparison.axis, comparison.keys);
  const auto left_out =
      sensitive ? rows_by_cell(*sensitive, comparison.axis, comparison.keys) : std::vector<CellPlace>{};
  const std::vector<std::size_t> columns_a = key_columns(a, comparison.axis, comparison.keys);

  Columns columns;
  std::vector<bool> met(rows_b.size(), false);
  while (a.next()) {
    const Key key = key_of(a, columns_a);
    ComparedCell cell = cell_of(key, CellVerdict::equal, label(a), "");
    const auto found = find_cell(rows_b, key);
    if (!found) {
      cell.verdict = CellVerdict::only_in_one;
    } else {
      met[*found] = true;
      b.read_at(rows_b[*found].row);
      cell.label_b = label(b);
      const bool fragile = text(a, "robust") == "no" || text(b, "robust") == "no";
      if (fragile || find_cell(left_out, key)) {
        cell.verdict = CellVerdict::sensitive;
      } else if (cell.label_a != cell.label_b) {
        cell.verdict = CellVerdict::classes_differ;
      } else if (repeats(a) && compare_columns({a, b}, comparison.cells.size(), tolerance, columns)) {
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
  for (const MapColumn& column : map_columns()) {
    if (is_compared(column) && has(a, column.name) != has(b, column.name))
      comparison.missing_columns.emplace_back(column.name);
  }
  return comparison;
}

std::string describe(const MapComparison& comparison, double tolerance) {
  std::string text;
  if (comparison.digest_a != comparison.digest_b) {
    text += fmt::format("digests: {} and {}, two studies\n", comparison.digest_a, comparison.digest_b);
  }
  const auto count = [&](CellVerdict verdict) { return comparison.count(verdict); };
  const auto changed = std::ranges::count_if(comparison.cells, [](const ComparedCell& cell) {
    return cell.verdict == CellVerdict::sensitive && cell.label_a != cell.label_b;
  });
  text += fmt::format(
      "{} cells: {} equal, {} with another class, {} with other numbers (beyond {}), {} in one map only\n",
      comparison.cells.size(), count(CellVerdict::equal), count(CellVerdict::classes_differ),
      count(CellVerdict::numbers_differ), tolerance, count(CellVerdict::only_in_one));
  if (count(CellVerdict::sensitive) > 0) {
    text += fmt::format("not compared: {} sensitive cells, {} of them with another class\n",
                        count(CellVerdict::sensitive), changed);
  }
  if (!comparison.missing_columns.empty()) {
    text += fmt::format("not compared: {}, which only one of the maps has\n",
                        fmt::join(comparison.missing_columns, ", "));
  }
  text += list_cells(comparison, CellVerdict::classes_differ);
  text += list_columns(comparison);
  text += list_cells(comparison, CellVerdict::only_in_one);
  return text + (comparison.equal() ? "equal\n" : "different\n");
}

}  // namespace rubsweep::report
