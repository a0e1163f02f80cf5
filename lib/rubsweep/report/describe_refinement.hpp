#pragma once

#include <span>
#include <string>
#include <string_view>

#include "rubsweep/sweep/grid.hpp"

namespace rubsweep::report {

/// What a complete refined map cost and what it may miss: lines for a terminal. `labels` as in
/// sweep::wanted_cells.
std::string describe_refinement(const sweep::Grid& grid, std::span<const int> labels);

/// Throws ConfigError where `grid` is refined: `what` needs every cell.
void refuse_refinement(const sweep::Grid& grid, std::string_view what);

}  // namespace rubsweep::report
