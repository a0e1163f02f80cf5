#pragma once

#include <span>
#include <string>

#include "rubsweep/sweep/grid.hpp"

namespace rubsweep::report {

/// What a refined map meets in any case (sweep::island_bound): a phrase.
std::string describe_island_bound(const sweep::Grid& grid);

/// What a complete refined map cost and what it may miss: lines for a terminal. `labels` as in
/// sweep::wanted_cells.
std::string describe_refinement(const sweep::Grid& grid, std::span<const int> labels);

}  // namespace rubsweep::report
