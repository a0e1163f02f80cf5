#pragma once

#include <string>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"
#include "shared/cell_argument.hpp"

namespace rubsweep::apps {

/// A cell of a sweep with axes over keys: its speed and unbalance, and the --set texts for its keys.
struct CellOnAxes {
  CellArgument cell;
  std::vector<std::string> overrides;
};

/// The cell at `values` on the axes with several values, in their order (speed, unbalance, x, y, z). An axis
/// with one value has it; one whose keys are all among `overrides` has the values given there. Without axes
/// over keys of several values, `values` are speed and unbalance. Throws ConfigError where there are not two
/// axes, UsageError where a speed or an unbalance is none.
CellOnAxes cell_on_axes(const CellValues& values, const sweep::Grid& grid,
                        const std::vector<std::string>& overrides);

}  // namespace rubsweep::apps
