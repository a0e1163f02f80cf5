#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::map {

/// Labels of the finished cells of a refined map, whichever process finished them. Not for several threads
/// at once.
class RefinedCells {
 public:
  /// Nothing is known. The grid must outlive it.
  explicit RefinedCells(const sweep::Grid& grid);

  /// All cells that any journal of the directory holds. Throws IoError.
  void read(const MapDirectory& directory);

  /// A finished cell with its line of the map.
  void add(std::size_t cell, const std::string& line);

  /// Cells that the map needs next, ascending; none when it is complete.
  std::vector<std::size_t> wanted() const;

  /// Cost of a complete map and the islands that it may miss, for a terminal.
  std::string description() const;

 private:
  const sweep::Grid& grid_;
  std::vector<int> labels_;
  std::map<std::string, int> numbers_;  ///< numbers of the labels
};

/// Writes `painted.csv` beside the complete refined map at `map`: a row for every cell of `grid` with its
/// axes, class, order and kind, and whether it was computed (1) or shows the motion of its block (0, see
/// sweep/refinement.hpp). Throws IoError, also where a row of the map is no cell of the grid.
void write_painted_map(const std::filesystem::path& map, const sweep::Grid& grid,
                       const batch::TableSource& source);

}  // namespace rubsweep::map
