#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "rubsweep/error.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::sweep {

/// What the second axis of the map holds.
enum class UnbalanceMeasure {
  whirl_ratio,    ///< largest normal excursion of the quiet motion / remaining clearance at the first stop
  eccentricity_m  ///< e of the disc, in metres
};

/// Its key in a configuration and its column of map.csv.
constexpr std::string_view to_string(UnbalanceMeasure measure) {
  switch (measure) {
    case UnbalanceMeasure::whirl_ratio:
      return "whirl_ratio";
    case UnbalanceMeasure::eccentricity_m:
      return "eccentricity_m";
  }
  throw SolverError("measure of the unbalance without a name");
}

/// Grid of cells. Speeds in Hz, strictly > 0; unbalance values >= 0 in the unit of `measure`.
struct Grid {
  std::vector<double> speed_hz;
  UnbalanceMeasure measure = UnbalanceMeasure::whirl_ratio;
  std::vector<double> unbalance;
};

/// Cells of the grid, speed fastest: cell = i_unbalance * speeds + i_speed.
std::size_t cell_count(const Grid& grid);

/// A value of the second axis as the scene takes it.
scene::Unbalance unbalance_of(const Grid& grid, double value);

/// Where a cell < cell_count(grid) lies.
scene::Place place_of(const Grid& grid, std::size_t cell);

/// The grid of the one cell there.
Grid grid_of(const scene::Place& place);

}  // namespace rubsweep::sweep
