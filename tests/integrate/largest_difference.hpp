#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rubsweep::integrate {

/// Largest difference between two lists of numbers, one by one.
template <class A, class B>
double largest_difference(const A& a, const B& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
  return largest;
}

}  // namespace rubsweep::integrate
