#pragma once

#include <cstddef>
#include <vector>

namespace rubsweep::page {

/// A part of a grid of cells: every `stride`-th value of each axis, beginning with its stride / 2-th.
struct ThinnedGrid {
  std::size_t speeds = 0, unbalances = 0;  ///< of the whole grid
  std::size_t speed_stride = 1, unbalance_stride = 1;

  bool whole() const { return speed_stride == 1 && unbalance_stride == 1; }

  /// The cells that stay, ascending; cell = i_unbalance x speeds + i_speed.
  std::vector<std::size_t> cells() const;
};

/// The densest such part of no more than `most` cells (>= 1) whose strides are about alike.
ThinnedGrid thinned_grid(std::size_t speeds, std::size_t unbalances, std::size_t most);

}  // namespace rubsweep::page
