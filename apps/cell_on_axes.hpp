#pragma once

#include <string>
#include <vector>

#include "cell_argument.hpp"
#include "rubsweep/sweep/grid.hpp"

namespace rubsweep::apps {

/// A cell of a sweep with axes over keys: its speed and unbalance, and what --set would write for its keys.
struct CellOnAxes {
  CellArgument cell;
  std::vector<std::string> overrides;
};

/// The cell whose place on the axes with several values, in their order (speed, unbalance, x, y, z), is
/// `values`. Axes with one value hold it; one whose keys are all among `overrides` holds what these say.
/// Without axes over keys that have several values it is speed and unbalance that `values` says. Throws
/// ConfigError where there are not two axes to say, UsageError where a speed or an unbalance is none.
CellOnAxes cell_on_axes(const CellValues& values, const sweep::Grid& grid,
                        const std::vector<std::string>& overrides);

}  // namespace rubsweep::apps
