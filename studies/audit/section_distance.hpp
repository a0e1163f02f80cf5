#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rubsweep::audit {

/// Largest component of the difference of two sections, in units of (clearance, clearance omega).
inline double section_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace rubsweep::audit
