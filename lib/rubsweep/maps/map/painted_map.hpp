#pragma once

#include <filesystem>

#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::map {

/// Writes `painted.csv` beside the complete refined map at `map`: a row for every cell of `grid` with its
/// axes, class, order and kind, and whether it was computed (1) or shows the motion of its block (0, see
/// sweep/refinement.hpp). Throws IoError, also where a row of the map is no cell of the grid.
void write_painted_map(const std::filesystem::path& map, const sweep::Grid& grid,
                       const batch::TableSource& source);

}  // namespace rubsweep::map
