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

/// Labels of the finished cells of a refined map, whichever process finished them. Only one thread at a time
/// may use it.
class RefinedCells {
 public:
  /// Begins without any labels. The grid must outlive this object.
  explicit RefinedCells(const sweep::Grid& grid);

  /// Reads all cells in the journals of the directory. Throws IoError.
  void read(const MapDirectory& directory);

  /// Adds a finished cell with its line of the map.
  void add(std::size_t cell, const std::string& line);

  /// Cells that the map needs next, ascending; none when it is complete.
  std::vector<std::size_t> wanted() const;

  /// Text for a terminal on a complete map: its cost, and the size of islands that it may miss.
  std::string description() const;

 private:
  const sweep::Grid& grid_;
  std::vector<int> labels_;
  std::map<std::string, int> numbers_;  ///< number of each label
};

/// Writes `painted.csv` beside the complete refined map at `map`: a row for every cell of `grid` with its
/// values on the axes, class, order and kind. The last column is 1 if the cell was computed, or 0 if it shows
/// the motion of its block (see sweep/refinement.hpp). Throws IoError, also where a row of the map is no cell
/// of the grid.
void write_painted_map(const std::filesystem::path& map, const sweep::Grid& grid,
                       const batch::TableSource& source);

}  // namespace rubsweep::map
