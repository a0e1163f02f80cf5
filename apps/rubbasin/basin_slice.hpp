#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "rubsweep/maps/basin/basin_entropy.hpp"
#include "rubsweep/maps/sweep/basin_sampling.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// Two numbers of the initial state that vary over a slice; the others are fixed.
struct SlicePlane {
  std::array<std::string, 2> names;           ///< column names with their units: x_m, vx_m_per_s, ...
  std::array<std::vector<double>, 2> values;  ///< horizontally (varying fastest) and vertically, ascending
};

/// Grid of initial states of one cell, with the attractor of each; row by row of the plane.
struct BasinSlice {
  SlicePlane plane;
  sweep::Basins basins;
  std::vector<std::string> statuses;

  basin::LabelGrid grid() const { return {plane.values[0].size(), plane.values[1].size(), basins.numbers}; }
};

/// Side of the boxes for the basin entropy, in initial states.
inline constexpr std::size_t entropy_box = 5;

/// Determines the attractors from the rows of a map. The map's cells are the initial states of the plane, in
/// the order of `grid`; its rows may have any order. Throws IoError where a state is missing or occurs twice.
BasinSlice read_basin_slice(const std::filesystem::path& map, const SlicePlane& plane,
                            const sweep::Grid& grid);

/// One row per initial state: both numbers, `attractor` (empty: failed), `label` (class and order), `status`.
std::string slice_csv(const BasinSlice& slice);

/// One row per attractor, the most frequent first: `attractor`, `label`, `starts`, `share`, `standard_error`,
/// the three lengths that identify it, and the first initial state that leads to it.
std::string attractors_csv(const BasinSlice& slice);

/// Summary for a terminal: shares, entropies and uncertainty exponent, each with its meaning.
std::string slice_summary(const BasinSlice& slice);

}  // namespace rubsweep::apps
