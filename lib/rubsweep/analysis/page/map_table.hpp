#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::page {

/// One column of a map. A column whose cells are all numbers or empty, some of them numbers, has `numbers`
/// (NaN where empty); any other has `words`.
struct MapColumn {
  std::string name;
  std::vector<double> numbers;
  std::vector<std::string> words;
};

/// A map.csv column by column, whatever columns it has.
struct MapTable {
  std::string version;  ///< version of the program that wrote it; empty: it does not say
  std::string digest;   ///< digest of its study; empty: it does not say
  std::size_t rows = 0;
  std::vector<MapColumn> columns;
  std::vector<std::size_t> cells{};  ///< cells of the rows, ascending, where it was read with their grid

  const MapColumn* find(std::string_view name) const;  ///< null: there is none

  /// A number of one row; empty where the cell is, or there is no such column of numbers.
  std::optional<double> number(std::string_view name, std::size_t row) const;

  /// A word of one row; empty where there is no such column of words.
  std::string_view word(std::string_view name, std::size_t row) const;
};

/// Throws IoError, with file:line where the text is at fault.
MapTable read_map_table(const std::filesystem::path& path);

/// A map of this grid, its rows in the order of the cells whatever their order in the file. Throws IoError
/// also where a row is no cell of the grid or one that is there twice, and where a cell is missing, which of
/// a refined map it may.
MapTable read_map_table(const std::filesystem::path& path, const sweep::Grid& grid);

/// A line across the map, such as the edge of a domain.
struct Boundary {
  std::string family;  ///< name of its family
  std::string kind;    ///< kind of the event there; may be empty
  std::vector<std::array<double, 2>>
      points;  ///< speed in Hz and unbalance in the unit of the map's second axis
};

/// Reads the lines of boundaries.csv: a header with a column `speed_hz` and one of the unbalance, called
/// `measure` (whirl_ratio or eccentricity_m) or else `unbalance` with or without a unit behind it. Where
/// there are columns `family` and `kind`, consecutive rows that agree in both belong to one line; a row
/// without numbers ends a line; rows are in the order of the line. Other columns are not looked at. Empty
/// where there is no such file, or where it says that it is of a map of another `digest`. Throws IoError,
/// with file:line where the text is at fault.
std::vector<Boundary> read_boundaries(const std::filesystem::path& path, std::string_view measure,
                                      std::string_view digest);

}  // namespace rubsweep::page
