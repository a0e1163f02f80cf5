#pragma once

#include <cmath>
#include <cstddef>

#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::test {

/// Index of the cell of a map over speed and unbalance at these shares of its axes, from 0 (first value) to 1
/// (last value).
inline std::size_t map_cell(const sweep::Grid& grid, double along_speed, double along_unbalance) {
  const auto index = [](std::size_t count, double share) {
    return static_cast<std::size_t>(std::lround(share * static_cast<double>(count - 1)));
  };
  const std::size_t speeds = grid.speed_hz.size();
  return index(grid.unbalance.size(), along_unbalance) * speeds + index(speeds, along_speed);
}

/// The scene of the cell with this index.
inline scene::Cell build_map_cell(const sweep::Study& study, std::size_t cell) {
  const scene::Place place = sweep::place_of(study.grid, cell);
  return scene::build_cell(study.machine, place.speed_hz, place.unbalance);
}

}  // namespace rubsweep::test
