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

/// One column of a map. A column has `numbers` (NaN where empty) if all its cells are numbers or empty and at
/// least one is a number. Any other column has `words`.
struct MapColumn {
  std::string name;
  std::vector<double> numbers;
  std::vector<std::string> words;
};

/// A map.csv, read column by column; any columns are allowed.
struct MapTable {
  std::string version;  ///< version of the program that wrote it; empty: unknown
  std::string digest;   ///< digest of its study; empty: unknown
  std::size_t rows = 0;
  std::vector<MapColumn> columns;
  std::vector<std::size_t> cells{};  ///< cells of the rows, ascending, if the map was read with its grid

  const MapColumn* find(std::string_view name) const;  ///< null where there is none

  /// Number in a row; empty where the cell is empty, or where no column of numbers has this name.
  std::optional<double> number(std::string_view name, std::size_t row) const;

  /// Word in a row; empty where no column of words has this name.
  std::string_view word(std::string_view name, std::size_t row) const;
};

/// Reads a map. Throws IoError, with file:line for an error in the text.
MapTable read_map_table(const std::filesystem::path& path);

/// Reads a map of this grid; sorts its rows by cell, whatever their order in the file. Throws IoError also
/// where a row is no cell of the grid, where a cell occurs twice, and where a cell is missing, except in a
/// refined map.
MapTable read_map_table(const std::filesystem::path& path, const sweep::Grid& grid);

/// Line drawn across the map, such as the boundary of a domain.
struct Boundary {
  std::string family;  ///< name of the family that it bounds
  std::string kind;    ///< kind of the event at the line; may be empty
  std::vector<std::array<double, 2>>
      points;  ///< speed in Hz and unbalance in the unit of the map's second axis
};

/// Reads the lines of boundaries.csv. It has a column `speed_hz` and a column for the unbalance, called
/// `measure` (whirl_ratio or eccentricity_m) or `unbalance`, with or without a unit behind it. Rows follow
/// the line. If there are columns `family` and `kind`, consecutive rows with the same family and kind belong
/// to one line. A row without numbers ends a line. Other columns are ignored. Empty where the file does not
/// exist, or has a `digest` of another study. Throws IoError, with file:line for an error in the text.
std::vector<Boundary> read_boundaries(const std::filesystem::path& path, std::string_view measure,
                                      std::string_view digest);

}  // namespace rubsweep::page
