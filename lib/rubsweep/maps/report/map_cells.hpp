#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::report {

/// Numbers that identify the cell of a row of map.csv: speed in Hz, unbalance in the unit of the second axis,
/// then the values of the axes over keys.
using CellKey = std::vector<double>;

/// A cell and the position of its row.
struct CellPlace {
  CellKey key;
  batch::CsvReader::RowPosition row;
};

/// Text after `mark` in the comments of a map; empty where there is none.
std::string comment_after(const batch::CsvReader& map, std::string_view mark);

/// Column of the second axis of two maps: whirl_ratio or eccentricity_m. It is the column with few values
/// that recur all over both maps; the other column is computed from it and may be empty. Throws IoError where
/// a column is missing or a file cannot be read.
std::string second_axis(const std::filesystem::path& a, const std::filesystem::path& b);

/// Columns of the axes over keys. Their names hold no comma.
std::vector<std::string> keys_of(const batch::CsvReader& map);

/// Columns that identify the cell of a row. Throws IoError where one is missing.
std::vector<std::size_t> key_columns(const batch::CsvReader& map, const std::string& axis,
                                     const std::vector<std::string>& keys);

/// Key of the row that was read last, by its `key_columns`. Throws IoError where one of them holds no number.
CellKey key_of(const batch::CsvReader& row, const std::vector<std::size_t>& columns);

/// Rows of a map, sorted by their cells. Throws IoError where a cell occurs twice.
std::vector<CellPlace> rows_by_cell(const std::filesystem::path& map, const std::string& axis,
                                    const std::vector<std::string>& keys);

/// Index of a cell in the list of `rows_by_cell`; empty where the list has no such cell.
std::optional<std::size_t> find_cell(const std::vector<CellPlace>& places, const CellKey& key);

/// Name of a cell < cell_count(grid) by the columns of a map: "speed_hz 60, whirl_ratio 0.4, kick.force_n
/// 200".
std::string name_of_cell(const sweep::Grid& grid, std::size_t cell);

/// Finds the cell of a grid to which each row of its map belongs, by the columns and not by the position of
/// the row. Takes one bit for each cell of the grid. The grid must outlive it.
class CellsOfRows {
 public:
  /// Throws IoError where a column that identifies the cell of a row is missing.
  CellsOfRows(const batch::CsvReader& map, const sweep::Grid& grid);

  /// Cell of the row that was read last. Throws IoError with file:line where it is no cell of the grid, or a
  /// cell that occurred before.
  std::size_t take(const batch::CsvReader& row);

  std::size_t taken() const { return taken_; }

  std::optional<std::size_t> first_missing() const;

  /// Throws IoError that names the first cell that has no row.
  void require_all() const;

 private:
  /// Columns of one axis: a single column, or one for each key of an axis over keys.
  struct Axis {
    std::vector<double> values;  ///< values of the axis in the grid
    std::vector<std::size_t> columns;
    /// factor of each column: the column holds the value of the axis times this factor
    std::vector<double> factors;
    std::size_t leading = 0;              ///< index of the first column that varies along the axis
    std::vector<double> leading_numbers;  ///< values of the axis in that column, ascending
    std::vector<std::size_t> places;      ///< index in `values` of each of these numbers
  };

  static Axis axis_of(const batch::CsvReader& map, const std::vector<double>& values,
                      const std::vector<std::string>& names, const std::vector<double>& factors);
  static std::optional<std::size_t> place_on(const Axis& axis, const batch::CsvReader& row);

  const sweep::Grid& grid_;
  std::filesystem::path path_;
  std::vector<Axis> axes_;  ///< axes of the grid, the fastest first
  std::vector<bool> met_;
  std::size_t taken_ = 0;
};

}  // namespace rubsweep::report
