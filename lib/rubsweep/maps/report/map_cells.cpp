#include "rubsweep/maps/report/map_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "rubsweep/core/error.hpp"

namespace rubsweep::report {

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

}  // namespace rubsweep::report
