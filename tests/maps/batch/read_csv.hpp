#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::batch {

/// A table read from a file: every row has as many cells as the header.
struct CsvTable {
  std::filesystem::path path;
  std::vector<std::string> comments;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> lines;  ///< line number of each row in the file, from 1
};

/// Reads a whole file by CsvReader and throws the same exceptions.
inline CsvTable read_csv(const std::filesystem::path& path) {
  CsvReader reader(path);
  CsvTable table{.path = path, .comments = {}, .header = reader.header(), .rows = {}, .lines = {}};
  while (reader.next()) {
    table.rows.push_back(reader.cells());
    table.lines.push_back(reader.place().line);
  }
  table.comments = reader.comments();
  return table;
}

/// Index of the column called `name`.
inline std::size_t column(const CsvTable& table, std::string_view name) {
  const auto found = std::ranges::find(table.header, name);
  if (found == table.header.end()) throw std::out_of_range(std::string(name));
  return static_cast<std::size_t>(found - table.header.begin());
}

/// The number in one cell; NaN for an empty cell.
inline double number(const CsvTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows.at(row).at(column);
  return cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell);
}

}  // namespace rubsweep::batch
