#include "rubsweep/page/thinned_grid.hpp"

namespace rubsweep::page {
namespace {

/// How many of `count` values are left at a stride.
std::size_t left(std::size_t count, std::size_t stride) {
  const std::size_t first = stride / 2;
  return first < count ? (count - first - 1) / stride + 1 : 0;
}

}  // namespace

std::vector<std::size_t> ThinnedGrid::cells() const {
  std::vector<std::size_t> kept;
  for (std::size_t j = unbalance_stride / 2; j < unbalances; j += unbalance_stride)
    for (std::size_t i = speed_stride / 2; i < speeds; i += speed_stride) kept.push_back(j * speeds + i);
  return kept;
}

ThinnedGrid thinned_grid(std::size_t speeds, std::size_t unbalances, std::size_t most) {
  ThinnedGrid grid{speeds, unbalances};
  while (left(speeds, grid.speed_stride) * left(unbalances, grid.unbalance_stride) > most) {
    // The axis that is still denser gives way, but never its last value.
    const bool speed = left(unbalances, grid.unbalance_stride) == 1 ||
                       (grid.speed_stride <= grid.unbalance_stride && left(speeds, grid.speed_stride) > 1);
    ++(speed ? grid.speed_stride : grid.unbalance_stride);
  }
  return grid;
}

}  // namespace rubsweep::page
