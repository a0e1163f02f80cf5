#pragma once

#include <algorithm>
#include <string>

namespace rubsweep::test {

/// The name of a parameterised test on the configuration of this stem below configs/: names of tests hold no
/// slash.
inline std::string name_of_map(std::string stem) {
  std::replace(stem.begin(), stem.end(), '/', '_');
  return stem;
}

}  // namespace rubsweep::test
