#pragma once

#include <functional>

#include "rubbranch_arguments.hpp"
#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps {

/// The scenes of a cell as two parameters change: that of --along and that of --curve.
struct BranchPlane {
  branch::orbits::ScenePlane scenes;
  /// Value of the second parameter on the branch, where the first one has a value: a branch along the speed
  /// at one whirl ratio has another eccentricity at every speed.
  std::function<double(double first)> second_on_branch;
  branch::orbits::ParameterRange second;
};

/// Throws ConfigError where the configuration has no such number, where both parameters say the unbalance or
/// are the same, and where the range does not hold the cell.
BranchPlane branch_plane(const RubbranchArguments& arguments, const config::RunConfig& config);

}  // namespace rubsweep::apps
