#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::report {

/// Which cell a row of map.csv is: speed in Hz, unbalance in the unit of the second axis, then the axes over
/// keys of the configuration.
using CellKey = std::vector<double>;

/// A cell and the position of its row.
struct CellPlace {
  CellKey key;
  batch::CsvReader::RowPosition row;
};

/// Text after `mark` in the comments of a map; empty where there is none.
std::string comment_after(const batch::CsvReader& map, std::string_view mark);

/// whirl_ratio or eccentricity_m, whichever the two maps are swept over: the axis holds few values that come
/// again and again in both, the other measure follows from it, and may be empty. Throws IoError where a
/// column is missing or a file cannot be read.
std::string second_axis(const std::filesystem::path& a, const std::filesystem::path& b);

/// The columns of the axes over keys, which hold no comma.
std::vector<std::string> keys_of(const batch::CsvReader& map);

/// Columns that identify the cell of a row. Throws IoError where one is missing.
std::vector<std::size_t> key_columns(const batch::CsvReader& map, const std::string& axis,
                                     const std::vector<std::string>& keys);

/// Key of the row that was read last, by its `key_columns`. Throws IoError where one holds no number.
CellKey key_of(const batch::CsvReader& row, const std::vector<std::size_t>& columns);

/// The rows of a map, in the order of their cells. Throws IoError where a cell is there twice.
std::vector<CellPlace> rows_by_cell(const std::filesystem::path& map, const std::string& axis,
                                    const std::vector<std::string>& keys);

/// Place of a cell in the list of `rows_by_cell`; none where there is no such cell.
std::optional<std::size_t> find_cell(const std::vector<CellPlace>& places, const CellKey& key);

}  // namespace rubsweep::report
