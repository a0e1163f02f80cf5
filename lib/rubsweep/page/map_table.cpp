#include "rubsweep/page/map_table.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::page {
namespace {

/// The comment that begins with `mark`, without it.
std::string comment(const batch::CsvTable& table, std::string_view mark) {
  for (const std::string& line : table.comments)
    if (line.starts_with(mark)) return line.substr(mark.size());
  return {};
}

bool is_number(const batch::CsvTable& table, std::size_t row, std::size_t column) {
  try {
    batch::number(table, row, column);
    return true;
  } catch (const IoError&) {
    return false;
  }
}

MapColumn read_column(const batch::CsvTable& table, std::size_t column) {
  MapColumn read{table.header[column], {}, {}};
  bool numbers = false;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][column].empty()) continue;
    numbers = is_number(table, row, column);
    if (!numbers) break;
  }
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (numbers) {
      read.numbers.push_back(batch::number(table, row, column));
    } else {
      read.words.push_back(table.rows[row][column]);
    }
  }
  return read;
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
  const batch::CsvTable table = batch::read_csv(path);
  MapTable map{comment(table, "rubsweep "), comment(table, "digest "), table.rows.size(), {}};
  for (std::size_t column = 0; column < table.header.size(); ++column)
    map.columns.push_back(read_column(table, column));
  return map;
}

}  // namespace rubsweep::page
