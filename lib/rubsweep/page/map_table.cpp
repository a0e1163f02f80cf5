#include "rubsweep/page/map_table.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::page {
namespace {

/// The comment that begins with `mark`, without it.
std::string comment(const batch::CsvReader& file, std::string_view mark) {
  for (const std::string& line : file.comments())
    if (line.starts_with(mark)) return line.substr(mark.size());
  return {};
}

bool is_number(const batch::CsvReader& file, std::size_t column) {
  try {
    file.number(column);
    return true;
  } catch (const IoError&) {
    return false;
  }
}

/// For each column, whether its cells are numbers or empty, and some of them numbers.
std::vector<bool> columns_of_numbers(const std::filesystem::path& path) {
  batch::CsvReader file(path);
  std::vector<bool> some(file.header().size(), false), all(file.header().size(), true);
  while (file.next()) {
    for (std::size_t column = 0; column < all.size(); ++column) {
      if (!all[column] || file.cells()[column].empty()) continue;
      some[column] = all[column] = is_number(file, column);
    }
  }
  return some;
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
  map.version = comment(file, "rubsweep ");
  map.digest = comment(file, "digest ");
  return map;
}

}  // namespace rubsweep::page
