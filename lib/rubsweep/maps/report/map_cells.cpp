#include "rubsweep/maps/report/map_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

using batch::csv_number;

/// Name of the cell to which the row read last belongs: the names and texts of these columns.
std::string name_of_row(const batch::CsvReader& row, const std::vector<std::size_t>& columns) {
  std::string name;
  for (const std::size_t column : columns)
    name += fmt::format("{}{} {}", name.empty() ? "" : ", ", row.header()[column], row.cells()[column]);
  return name;
}

}  // namespace

namespace fs = std::filesystem;

using batch::CsvReader;

std::string comment_after(const CsvReader& map, std::string_view mark) {
  for (const std::string& comment : map.comments()) {
    if (comment.starts_with(mark)) return comment.substr(mark.size());
  }
  return "";
}

std::string second_axis(const fs::path& a, const fs::path& b) {
  std::vector<double> eccentricities, ratios;
  bool without_ratio = false;
  for (const fs::path& map : {a, b}) {
    CsvReader rows(map);
    const std::size_t eccentricity = rows.column("eccentricity_m"), ratio = rows.column("whirl_ratio");
    while (rows.next()) {
      const double e = rows.number(eccentricity), r = rows.number(ratio);
      if (!std::isnan(e)) eccentricities.push_back(e);
      if (!std::isnan(r)) ratios.push_back(r);
      without_ratio |= std::isnan(r) && !std::isnan(e);
    }
  }
  const auto distinct = [](std::vector<double>& values) {
    std::ranges::sort(values);
    return std::unique(values.begin(), values.end()) - values.begin();
  };
  return without_ratio || distinct(eccentricities) < distinct(ratios) ? "eccentricity_m" : "whirl_ratio";
}

std::vector<std::string> keys_of(const CsvReader& map) {
  std::vector<std::string> keys;
  std::istringstream names(comment_after(map, "keys "));
  for (std::string name; std::getline(names, name, ',');) keys.push_back(name);
  return keys;
}

std::vector<std::size_t> key_columns(const CsvReader& map, const std::string& axis,
                                     const std::vector<std::string>& keys) {
  std::vector<std::size_t> columns{map.column("speed_hz"), map.column(axis)};
  for (const std::string& key : keys) columns.push_back(map.column(key));
  return columns;
}

CellKey key_of(const CsvReader& row, const std::vector<std::size_t>& columns) {
  CellKey key;
  for (const std::size_t column : columns) {
    key.push_back(row.number(column));
    if (!std::isnan(key.back())) continue;
    throw IoError(fmt::format("{}:{}: column '{}' does not say which cell this is, allowed: a number",
                              row.path().string(), row.place().line, row.header().at(column)));
  }
  return key;
}

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

std::optional<std::size_t> find_cell(const std::vector<CellPlace>& places, const CellKey& key) {
  const auto place = std::ranges::lower_bound(places, key, {}, &CellPlace::key);
  if (place == places.end() || place->key != key) return std::nullopt;
  return static_cast<std::size_t>(place - places.begin());
}

std::string name_of_cell(const sweep::Grid& grid, std::size_t cell) {
  std::string name;
  for (const auto& [column, value] : sweep::columns_of_place(grid, cell))
    name += fmt::format("{}{} {}", name.empty() ? "" : ", ", column, csv_number(value));
  return name;
}

CellsOfRows::CellsOfRows(const batch::CsvReader& map, const sweep::Grid& grid)
    : grid_(grid), path_(map.path()), met_(sweep::cell_count(grid), false) {
  axes_.push_back(axis_of(map, grid.speed_hz, {"speed_hz"}, {1}));
  axes_.push_back(axis_of(map, grid.unbalance, {std::string(to_string(grid.measure))}, {1}));
  for (const sweep::KeyAxis& axis : grid.axes)
    axes_.push_back(axis_of(map, axis.values, axis.keys, axis.factors));
}

CellsOfRows::Axis CellsOfRows::axis_of(const batch::CsvReader& map, const std::vector<double>& values,
                                       const std::vector<std::string>& names,
                                       const std::vector<double>& factors) {
  Axis axis{values, {}, factors, 0, {}, std::vector<std::size_t>(values.size())};
  for (const std::string& name : names) axis.columns.push_back(map.column(name));
  while (axis.leading + 1 < factors.size() && factors[axis.leading] == 0) ++axis.leading;
  const auto number = [&](std::size_t place) { return factors[axis.leading] * values[place]; };
  std::iota(axis.places.begin(), axis.places.end(), std::size_t{0});
  std::ranges::sort(axis.places, {}, number);
  for (const std::size_t place : axis.places) axis.leading_numbers.push_back(number(place));
  return axis;
}

std::optional<std::size_t> CellsOfRows::place_on(const Axis& axis, const batch::CsvReader& row) {
  const auto& numbers = axis.leading_numbers;
  const auto found = std::ranges::lower_bound(numbers, row.number(axis.columns[axis.leading]));
  if (found == numbers.end()) return std::nullopt;
  const std::size_t place = axis.places[static_cast<std::size_t>(found - numbers.begin())];
  for (std::size_t i = 0; i < axis.columns.size(); ++i)
    if (row.number(axis.columns[i]) != axis.factors[i] * axis.values[place]) return std::nullopt;
  return place;
}

std::size_t CellsOfRows::take(const batch::CsvReader& row) {
  std::size_t cell = 0, stride = 1;
  std::vector<std::size_t> columns;
  bool known = true;
  for (const Axis& axis : axes_) {
    columns.insert(columns.end(), axis.columns.begin(), axis.columns.end());
    const auto place = place_on(axis, row);
    known = known && place;
    cell += stride * place.value_or(0);
    stride *= axis.values.size();
  }
  const auto refuse = [&](std::string_view what) {
    throw IoError(fmt::format("{}:{}: the row of {} {}", path_.string(), row.place().line,
                              name_of_row(row, columns), what));
  };
  if (!known) refuse("is no cell of its configuration");
  if (met_[cell]) refuse("is there twice");
  met_[cell] = true;
  ++taken_;
  return cell;
}

std::optional<std::size_t> CellsOfRows::first_missing() const {
  if (taken_ == met_.size()) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::find(met_, false) - met_.begin());
}

void CellsOfRows::require_all() const {
  const auto missing = first_missing();
  if (!missing) return;
  throw IoError(fmt::format("{}: holds {} cells of {}, there is no row of {}", path_.string(), taken_,
                            met_.size(), name_of_cell(grid_, *missing)));
}

}  // namespace rubsweep::report
