#pragma once

#include <string>

#include "rubbranch_arguments.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps {

/// The scenes of a cell as functions of one parameter.
struct BranchFamily {
  branch::orbits::SceneFamily scenes;
  double start = 0;          ///< value of the parameter at the cell
  double low = 0, high = 0;  ///< ends of the range
};

/// Throws ConfigError where the configuration has no such number, or where the cell is outside the range.
BranchFamily branch_family(const RubbranchArguments& arguments, const config::RunConfig& config);

}  // namespace rubsweep::apps
