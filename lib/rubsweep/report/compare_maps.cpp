#include "rubsweep/report/compare_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "rubsweep/error.hpp"

namespace rubsweep::report {
namespace {

using batch::CsvTable;
using Key = std::pair<double, double>;

constexpr std::array<std::string_view, 2> words{"orbit", "whirl"};
constexpr std::array<std::string_view, 10> numbers{
    "eccentricity_m",       "comb_spacing",           "hits_per_revolution",     "contact_fraction",
    "peak_displacement_m",  "amplitude_1x_forward_m", "amplitude_1x_backward_m", "dominant_order",
    "dominant_amplitude_m", "peak_contact_force_n"};

/// The axis holds few values that come again and again; the other measure follows from it.
std::string second_axis(const CsvTable& table) {
  const auto distinct = [&](std::string_view name) {
    const std::size_t place = batch::column(table, name);
    std::set<std::string> values;
    for (const auto& row : table.rows) values.insert(row[place]);
    return values.size();
  };
  return distinct("eccentricity_m") < distinct("whirl_ratio") ? "eccentricity_m" : "whirl_ratio";
}

/// Rows of a table by their cell.
std::map<Key, std::size_t> rows_by_cell(const CsvTable& table, const std::string& axis) {
  const std::size_t speed = batch::column(table, "speed_hz"), unbalance = batch::column(table, axis);
  std::map<Key, std::size_t> rows;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const Key key{batch::number(table, row, speed), batch::number(table, row, unbalance)};
    if (!rows.emplace(key, row).second) {
      throw IoError(
          fmt::format("{}:{}: this cell is in the map twice", table.path.string(), table.lines[row]));
    }
  }
  return rows;
}

const std::string& text(const CsvTable& table, std::size_t row, std::string_view name) {
  return table.rows[row][batch::column(table, name)];
}

std::string label(const CsvTable& table, std::size_t row) {
  const std::string &name = text(table, row, "class"), &order = text(table, row, "order");
  return order.empty() || order == "1" ? name : fmt::format("{} 1/{}", name, order);
}

/// Motions whose numbers do not depend on when one looks.
bool repeats(const CsvTable& table, std::size_t row) {
  const std::string& name = text(table, row, "class");
  return name == "non_contact" || name == "synchronous" || name == "subharmonic";
}

std::string digest_of(const CsvTable& table) {
  for (const std::string& comment : table.comments) {
    if (comment.starts_with("digest ")) return comment.substr(7);
  }
  return "";
}

/// A pair of rows for one cell, and what their columns say.
struct Pair {
  const CsvTable &a, &b;
  std::size_t row_a, row_b;

  double number(const CsvTable& table, std::size_t row, std::string_view name) const {
    return batch::number(table, row, batch::column(table, name));
  }

  /// Empty when both are empty or equal to the last bit.
  std::optional<double> relative_difference(std::string_view name) const {
    const double x = number(a, row_a, name), y = number(b, row_b, name);
    if (x == y) return std::nullopt;
    double scale = std::max(std::abs(x), std::abs(y));
    if (name.ends_with("_m")) {
      const double peak_m = number(a, row_a, "peak_displacement_m");
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
    worst.a = text(pair.a, pair.row_a, column);
    worst.b = text(pair.b, pair.row_b, column);
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

/// True when something differs.
bool compare_columns(const Pair& pair, std::size_t cell, double tolerance, Columns& columns) {
  bool differs = false;
  const auto found = [&](std::string_view column, std::optional<double> size) {
    columns.add(column, cell, size, pair);
    differs = true;
  };
  for (const std::string_view name : words) {
    if (text(pair.a, pair.row_a, name) != text(pair.b, pair.row_b, name)) found(name, std::nullopt);
  }
  for (const std::string_view name : numbers) {
    const bool none_a = text(pair.a, pair.row_a, name).empty(),
               none_b = text(pair.b, pair.row_b, name).empty();
    if (none_a || none_b) {
      if (none_a != none_b) found(name, std::nullopt);
      continue;
    }
    const auto size = pair.relative_difference(name);
    if (size && !(*size <= tolerance)) found(name, size);
  }
  return differs;
}

std::string place(const MapComparison& comparison, const ComparedCell& cell) {
  return fmt::format("speed_hz {}, {} {}", cell.speed_hz, comparison.axis, cell.unbalance);
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

MapComparison compare_maps(const CsvTable& a, const CsvTable& b, double tolerance,
                           const CsvTable* sensitive) {
  MapComparison comparison;
  comparison.axis = second_axis(a);
  comparison.digest_a = digest_of(a);
  comparison.digest_b = digest_of(b);
  const auto rows_a = rows_by_cell(a, comparison.axis), rows_b = rows_by_cell(b, comparison.axis);
  const auto left_out = sensitive ? rows_by_cell(*sensitive, comparison.axis) : std::map<Key, std::size_t>{};
  std::vector<Key> in_order(rows_a.size());
  for (const auto& [key, row] : rows_a) in_order[row] = key;

  Columns columns;
  for (const Key& key : in_order) {
    ComparedCell cell{
        .speed_hz = key.first, .unbalance = key.second, .label_a = label(a, rows_a.at(key)), .label_b = ""};
    const auto found = rows_b.find(key);
    if (found == rows_b.end()) {
      cell.verdict = CellVerdict::only_in_one;
    } else {
      const Pair pair{a, b, rows_a.at(key), found->second};
      cell.label_b = label(b, pair.row_b);
      const bool fragile = text(a, pair.row_a, "robust") == "no" || text(b, pair.row_b, "robust") == "no";
      if (fragile || left_out.contains(key)) {
        cell.verdict = CellVerdict::sensitive;
      } else if (cell.label_a != cell.label_b) {
        cell.verdict = CellVerdict::classes_differ;
      } else if (repeats(a, pair.row_a) &&
                 compare_columns(pair, comparison.cells.size(), tolerance, columns)) {
        cell.verdict = CellVerdict::numbers_differ;
      }
    }
    comparison.cells.push_back(std::move(cell));
  }
  for (const auto& [key, row] : rows_b) {
    if (rows_a.contains(key)) continue;
    comparison.cells.push_back({key.first, key.second, CellVerdict::only_in_one, "", label(b, row)});
  }
  comparison.columns = columns.list();
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
  text += list_cells(comparison, CellVerdict::classes_differ);
  text += list_columns(comparison);
  text += list_cells(comparison, CellVerdict::only_in_one);
  return text + (comparison.equal() ? "equal\n" : "different\n");
}

}  // namespace rubsweep::report
