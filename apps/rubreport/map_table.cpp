#include "rubreport/map_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::page {
namespace {

bool is_number(const batch::CsvReader& file, std::size_t column) {
  try {
    file.number(column);
    return true;
  } catch (const IoError&) {
    return false;
  }
}

/// Whether a column of this name has only numbers in every map.
bool has_numbers(const std::string& name) {
  using report::Comparison;
  const auto columns = report::map_columns();
  const auto known = std::ranges::find(columns, name, &report::MapColumn::name);
  return known != columns.end() &&
         (known->comparison == Comparison::key || known->comparison == Comparison::number);
}

void require_class(const batch::CsvReader& file, std::size_t column) {
  const std::string& word = file.cells()[column];
  if (response::motion::motion_class_of(word)) return;
  throw IoError(
      fmt::format("{}:{}: '{}' is no class of a motion", file.path().string(), file.place().line, word));
}

/// For each column, whether it is a column of numbers: its cells are numbers or empty, and not all are empty.
/// Throws IoError where a column that has numbers in every map contains anything else.
std::vector<bool> columns_of_numbers(const std::filesystem::path& path) {
  batch::CsvReader file(path);
  const auto& names = file.header();
  std::vector<bool> some(names.size(), false), all(names.size(), true), always;
  for (const std::string& name : names) always.push_back(has_numbers(name));
  while (file.next()) {
    for (std::size_t column = 0; column < all.size(); ++column) {
      if (names[column] == "class") require_class(file, column);
      if (always[column]) file.number(column);
      if (!all[column] || file.cells()[column].empty()) continue;
      some[column] = all[column] = is_number(file, column);
    }
  }
  return some;
}

template <class Value>
std::vector<Value> in_order(const std::vector<Value>& rows,
                            const std::vector<std::pair<std::size_t, std::size_t>>& cells) {
  std::vector<Value> ordered;
  for (const auto& [cell, row] : cells) ordered.push_back(rows[row]);
  return ordered;
}

/// First column with the name `name` or, if `or_begins` is true, with a name that begins with it.
std::optional<std::size_t> column_called(const batch::CsvReader& file, std::string_view name,
                                         bool or_begins = false) {
  const auto found = std::find_if(file.header().begin(), file.header().end(), [&](const std::string& header) {
    return header == name || (or_begins && header.starts_with(name));
  });
  if (found == file.header().end()) return std::nullopt;
  return static_cast<std::size_t>(found - file.header().begin());
}

std::size_t unbalance_column(const batch::CsvReader& file, std::string_view measure) {
  if (const auto exact = column_called(file, measure)) return *exact;
  const auto other = column_called(file, "unbalance", true);
  if (other) return *other;
  throw IoError(fmt::format("{}: no column {} or unbalance", file.path().string(), measure));
}

}  // namespace

const MapColumn* MapTable::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const MapColumn& column) { return column.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

std::optional<double> MapTable::number(std::string_view name, std::size_t row) const {
  const MapColumn* column = find(name);
  if (!column || column->numbers.empty() || std::isnan(column->numbers[row])) return std::nullopt;
  return column->numbers[row];
}

std::string_view MapTable::word(std::string_view name, std::size_t row) const {
  const MapColumn* column = find(name);
  return column && !column->words.empty() ? std::string_view(column->words[row]) : std::string_view();
}

MapTable read_map_table(const std::filesystem::path& path) {
  const std::vector<bool> numbers = columns_of_numbers(path);
  batch::CsvReader file(path);
  MapTable map;
  for (const std::string& name : file.header()) map.columns.push_back({name, {}, {}});
  for (; file.next(); ++map.rows) {
    for (std::size_t column = 0; column < map.columns.size(); ++column) {
      if (numbers[column]) {
        map.columns[column].numbers.push_back(file.number(column));
      } else {
        map.columns[column].words.push_back(file.cells()[column]);
      }
    }
  }
  map.version = report::comment_after(file, "rubsweep ");
  map.digest = report::comment_after(file, "digest ");
  return map;
}

MapTable read_map_table(const std::filesystem::path& path, const sweep::Grid& grid) {
  batch::CsvReader file(path);
  report::CellsOfRows cells_of_rows(file, grid);
  std::vector<std::pair<std::size_t, std::size_t>> cells;  // each cell with its row
  while (file.next()) cells.emplace_back(cells_of_rows.take(file), cells.size());
  if (!grid.refinement) cells_of_rows.require_all();
  MapTable map = read_map_table(path);
  const bool in_place = std::ranges::is_sorted(cells);
  std::ranges::sort(cells);
  for (const auto& [cell, row] : cells) map.cells.push_back(cell);
  if (in_place) return map;
  for (MapColumn& column : map.columns) {
    if (!column.numbers.empty()) column.numbers = in_order(column.numbers, cells);
    if (!column.words.empty()) column.words = in_order(column.words, cells);
  }
  return map;
}

std::vector<Boundary> read_boundaries(const std::filesystem::path& path, std::string_view measure,
                                      std::string_view digest) {
  if (!std::filesystem::exists(path)) return {};
  batch::CsvReader file(path);
  const std::string of_map = report::comment_after(file, "digest ");
  if (!of_map.empty() && of_map != digest) return {};
  const std::size_t speed = file.column("speed_hz"), unbalance = unbalance_column(file, measure);
  const auto family = column_called(file, "family"), kind = column_called(file, "kind");
  std::vector<Boundary> boundaries;
  for (bool ended = true; file.next();) {
    const double x = file.number(speed), y = file.number(unbalance);
    const Boundary here{family ? file.cells()[*family] : "", kind ? file.cells()[*kind] : "", {}};
    if (!std::isfinite(x) || !std::isfinite(y)) {
      ended = true;
      continue;
    }
    if (ended || boundaries.back().family != here.family || boundaries.back().kind != here.kind)
      boundaries.push_back(here);
    boundaries.back().points.push_back({x, y});
    ended = false;
  }
  return boundaries;
}

}  // namespace rubsweep::page
