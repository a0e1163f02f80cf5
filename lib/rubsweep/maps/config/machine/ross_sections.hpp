#pragma once

#include <vector>

#include "rubsweep/maps/config/machine/ross_elements.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Parts of a ROSS file that hold for the whole rotor.
struct RossSettings {
  double mass_damping_per_s = 0;   ///< alpha: damping of all masses, in the fixed frame
  double stiffness_damping_s = 0;  ///< beta: damping of the shaft by its stiffness
  /// Whether coefficients over `frequency` are those of a whirl frequency: since version 3. Before that it
  /// was the speed of the shaft.
  bool whirl_tables = false;
};

/// Reads ross_version and parameters of a file, both optional. Versions beyond 3, unknown parameters and
/// damping ratios of modes are problems.
RossSettings read_ross_settings(const yaml::Value& file);

/// Sections of a ROSS file by what they are; thrust bearings, which act along the axis alone, are none of
/// them.
struct RossSections {
  std::vector<RossElement> shaft, discs, masses, supports;
};

/// Sorts the sections of a file. Those of unknown classes are problems with their names.
RossSections read_ross_sections(const yaml::Value& root);

}  // namespace rubsweep::config::machine
