#pragma once

#include <functional>

#include "rubbranch_arguments.hpp"
#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps {

/// The scenes of a cell as functions of two parameters, those of --along and --curve.
struct BranchPlane {
  branch::orbits::ScenePlane scenes;
  /// Value of the second parameter on the branch at a value of the first one. A branch along the speed at
  /// constant whirl ratio, for instance, has another eccentricity at every speed.
  std::function<double(double first)> second_on_branch;
  branch::orbits::ParameterRange second;
};

/// Throws ConfigError where the configuration has no such number, where both parameters are an unbalance or
/// are equal, and where the cell is outside the range.
BranchPlane branch_plane(const RubbranchArguments& arguments, const config::RunConfig& config);

}  // namespace rubsweep::apps
