#pragma once

#include <span>
#include <string>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::report {

/// Guarantee of a refined map (sweep::island_bound): a phrase.
std::string describe_island_bound(const sweep::Grid& grid);

/// Cost of a complete refined map and the islands that it may miss: lines for a terminal. `labels` as in
/// sweep::wanted_cells.
std::string describe_refinement(const sweep::Grid& grid, std::span<const int> labels);

}  // namespace rubsweep::report
