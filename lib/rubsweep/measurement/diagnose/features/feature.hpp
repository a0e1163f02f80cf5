#pragma once

#include <string>
#include <vector>

namespace rubsweep::diagnose::features {

/// A number that describes a motion and stays the same when the motion is turned, scaled, or recorded from
/// another mark on the shaft. Of one probe: when it is scaled, or recorded from another mark.
struct Feature {
  std::string name;
  double value = 0;
};
using Features = std::vector<Feature>;

void add(Features& features, std::string name, double value);

}  // namespace rubsweep::diagnose::features
