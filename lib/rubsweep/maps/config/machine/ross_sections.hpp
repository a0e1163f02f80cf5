#pragma once

#include <vector>

#include "rubsweep/maps/config/machine/ross_elements.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Settings of a ROSS file that hold for the whole rotor.
struct RossSettings {
  double mass_damping_per_s = 0;   ///< alpha: damping of all masses, in the fixed frame
  double stiffness_damping_s = 0;  ///< beta: damping of the shaft by its stiffness
  /// true: tables over `frequency` use the whirl frequency, as since version 3; false: the speed of the
  /// shaft, as in earlier versions.
  bool whirl_tables = false;
};

/// Reads `ross_version` and `parameters` of a file, both optional. Problems: versions above 3, unknown
/// parameters, damping ratios of modes.
RossSettings read_ross_settings(const yaml::Value& file);

/// Elements of a ROSS file, sorted by kind, without thrust bearings, which act along the axis alone.
struct RossSections {
  std::vector<RossElement> shaft, discs, masses, supports;
};

/// Sorts the elements of a file. An element of unknown class is reported with its name.
RossSections read_ross_sections(const yaml::Value& root);

}  // namespace rubsweep::config::machine
