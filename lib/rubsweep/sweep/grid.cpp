#include "rubsweep/sweep/grid.hpp"

#include <variant>

#include "rubsweep/overloaded.hpp"

namespace rubsweep::sweep {

std::size_t cell_count(const Grid& grid) { return grid.speed_hz.size() * grid.unbalance.size(); }

scene::Unbalance unbalance_of(const Grid& grid, double value) {
  switch (grid.measure) {
    case UnbalanceMeasure::whirl_ratio:
      return scene::WhirlRatio{value};
    case UnbalanceMeasure::eccentricity_m:
      return scene::Eccentricity{value};
  }
  throw SolverError("measure of the unbalance without a meaning");
}

scene::Place place_of(const Grid& grid, std::size_t cell) {
  const std::size_t speeds = grid.speed_hz.size();
  return {grid.speed_hz[cell % speeds], unbalance_of(grid, grid.unbalance[cell / speeds])};
}

Grid grid_of(const scene::Place& place) {
  return std::visit(
      overloaded{[&](const scene::WhirlRatio& ratio) {
                   return Grid{{place.speed_hz}, UnbalanceMeasure::whirl_ratio, {ratio.value}};
                 },
                 [&](const scene::Eccentricity& eccentricity) {
                   return Grid{{place.speed_hz}, UnbalanceMeasure::eccentricity_m, {eccentricity.value_m}};
                 }},
      place.unbalance);
}

}  // namespace rubsweep::sweep
