#pragma once

#include <cstddef>
#include <vector>

namespace rubsweep::basin {

/// Attractors of a rectangular grid of initial conditions: a number for each attractor.
struct LabelGrid {
  std::size_t columns = 0, rows = 0;
  std::vector<int> labels;  ///< columns * rows, row by row

  int at(std::size_t column, std::size_t row) const { return labels[row * columns + column]; }
};

}  // namespace rubsweep::basin
