#pragma once

#include <string>
#include <vector>

#include "rubsweep/maps/sweep/grid.hpp"
#include "shared/cell_argument.hpp"

namespace rubsweep::apps {

/// A cell of a sweep over configuration keys: its speed and unbalance, and --set options for its keys.
struct CellOnAxes {
  CellArgument cell;
  std::vector<std::string> overrides;
};

/// The cell at `values` on the axes with several values, in the order speed, unbalance, x, y, z. An axis with
/// one value keeps it; an axis whose keys are all set in `overrides` takes its values from there. If no key
/// axis has several values, `values` are speed and unbalance. Throws ConfigError where there are not exactly
/// two axes with several values, UsageError for an invalid speed or unbalance.
CellOnAxes cell_on_axes(const CellValues& values, const sweep::Grid& grid,
                        const std::vector<std::string>& overrides);

}  // namespace rubsweep::apps
