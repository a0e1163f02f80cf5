#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubsweep::apps {

/// Result of comparing one cell of two maps.
enum class CellVerdict {
  equal,
  sensitive,       ///< not compared: listed as sensitive, or `robust` is `no` in a map
  numbers_differ,  ///< same class and order, but a number or word of the motion differs
  classes_differ,  ///< class or order differs
  only_in_one      ///< the other map lacks this cell
};

struct ComparedCell {
  double speed_hz = 0;
  double unbalance = 0;        ///< unbalance in the unit of the maps' second axis
  std::vector<double> keys{};  ///< values of MapComparison::keys
  CellVerdict verdict = CellVerdict::equal;
  /// Class and order, such as "subharmonic 1/2"; empty where the map lacks this cell.
  std::string label_a, label_b;
};

/// Number of differences in one column, and the largest one.
struct ColumnDifference {
  std::string column;
  std::size_t cells = 0;          ///< number of cells in which it differs
  std::optional<double> largest;  ///< relative; empty: a word differs, or a number is missing on one side
  std::size_t cell = 0;           ///< cell with the largest difference: index into MapComparison::cells
  std::string a, b;
};

struct MapComparison {
  std::string axis;                          ///< second axis: whirl_ratio or eccentricity_m
  std::vector<std::string> keys;             ///< columns of the axes over keys of the configuration
  std::vector<ComparedCell> cells;           ///< cells of A in its order, then those only in B
  std::vector<ColumnDifference> columns;     ///< differing columns, from cells with equal class and order
  std::vector<std::string> missing_columns;  ///< columns that only one map has, so they are not compared
  std::string digest_a, digest_b;            ///< empty where a file has no digest

  std::size_t count(CellVerdict verdict) const;
  bool equal() const;  ///< whether all cells are equal or sensitive
};

/// Compares two files like map.csv cell by cell. Class and order must be equal. In cells that are at rest,
/// synchronous or subharmonic in both maps, orbit and whirl must be equal, too. In these cells every measured
/// number must also agree within `tolerance` relative to the larger of both; lengths are compared relative to
/// the cell's peak displacement. Numbers of motions that never repeat, and the length of transients, are not
/// compared. `sensitive` is a table of cells to leave out, with the columns that identify a cell.
///
/// Measured columns that only one of two versions of maps has are left out. Throws IoError where a column
/// that identifies a cell or its class is missing, a number is invalid, a cell occurs twice, the maps vary
/// different keys, or a file cannot be read. The maps are read row by row; only places and results of the
/// cells are kept in memory.
MapComparison compare_maps(const std::filesystem::path& a, const std::filesystem::path& b, double tolerance,
                           const std::optional<std::filesystem::path>& sensitive = std::nullopt);

}  // namespace rubsweep::apps
