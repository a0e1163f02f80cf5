#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubsweep::apps {

/// Verdict on a cell of two maps.
enum class CellVerdict {
  equal,
  sensitive,       ///< listed as such or `robust` is `no` in one of the maps: not compared
  numbers_differ,  ///< class and order are equal, a number or a word of the motion is not
  classes_differ,  ///< class or order differ
  only_in_one      ///< the other map has no such cell
};

struct ComparedCell {
  double speed_hz = 0;
  double unbalance = 0;        ///< unbalance in the unit of the maps' second axis
  std::vector<double> keys{};  ///< values of MapComparison::keys
  CellVerdict verdict = CellVerdict::equal;
  /// Class and order, such as "subharmonic 1/2"; empty where there is no such cell.
  std::string label_a, label_b;
};

/// The worst difference of one column.
struct ColumnDifference {
  std::string column;
  std::size_t cells = 0;          ///< number of cells in which it differs
  std::optional<double> largest;  ///< relative difference; empty: a word, or a number on one side only
  std::size_t cell = 0;           ///< where, an index into MapComparison::cells
  std::string a, b;
};

struct MapComparison {
  std::string axis;                          ///< second axis: whirl_ratio or eccentricity_m
  std::vector<std::string> keys;             ///< columns of the axes over keys of the configuration
  std::vector<ComparedCell> cells;           ///< cells of A in its order, then those that only B has
  std::vector<ColumnDifference> columns;     ///< columns that differ, of cells with equal class and order
  std::vector<std::string> missing_columns;  ///< columns that only one of the maps has: not compared
  std::string digest_a, digest_b;            ///< empty where a file says none

  std::size_t count(CellVerdict verdict) const;
  bool equal() const;  ///< nothing but equal and sensitive cells
};

/// Compares two files like map.csv cell by cell. Class and order must be equal. In cells at rest, synchronous
/// or subharmonic in both, orbit and whirl must be equal too and every measured number within `tolerance`
/// relative to the larger of both, lengths relative to the cell's peak displacement; numbers of motions that
/// never repeat, and how long a transient lasted, are no property of the cell. `sensitive` is a
/// table of cells to leave out, with the columns that say which cell it is. Measured columns that a map of
/// another version lacks are left out. Throws IoError when a column that says which cell and class it is is
/// missing or a number is none, when a map holds a cell twice, when the maps are swept over different keys,
/// or a file cannot be read.
///
/// The maps are read a row at a time; of their cells only places and verdicts are kept.
MapComparison compare_maps(const std::filesystem::path& a, const std::filesystem::path& b, double tolerance,
                           const std::optional<std::filesystem::path>& sensitive = std::nullopt);

}  // namespace rubsweep::apps
