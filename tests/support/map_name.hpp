#pragma once

#include <algorithm>
#include <string>

namespace rubsweep::test {

/// Name of a parameterised test for a configuration below configs/; names of tests must not contain slashes.
inline std::string name_of_map(std::string stem) {
  std::replace(stem.begin(), stem.end(), '/', '_');
  return stem;
}

}  // namespace rubsweep::test
