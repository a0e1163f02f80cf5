#pragma once

#include <vector>

#include "rubsweep/maps/config/machine/ross_elements.hpp"

namespace rubsweep::config::machine {

/// Sections of a ROSS file by what they are; thrust bearings, which act along the axis alone, are none of
/// them.
struct RossSections {
  std::vector<RossElement> shaft, discs, masses, supports;
};

/// Sorts the sections of a file. Those of unknown classes are problems with their names.
RossSections read_ross_sections(const yaml::Value& root);

}  // namespace rubsweep::config::machine
