#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rubsweep::recording {

/// Instants at which a shaft with the speed f + r t, in Hz, has completed whole turns.
inline std::vector<double> turns_s(int count, double f, double r) {
  std::vector<double> marks;
  for (int n = 0; n < count; ++n) {
    const double turns = n + 0.3;
    marks.push_back(2 * turns / (f + std::sqrt(f * f + 2 * r * turns)));
  }
  return marks;
}

inline double largest_error(const std::vector<double>& marks, const std::vector<double>& truth) {
  double largest = 0;
  for (std::size_t k = 0; k < truth.size(); ++k)
    largest = std::max(largest, std::abs(marks.at(k) - truth[k]));
  return largest;
}

}  // namespace rubsweep::recording
