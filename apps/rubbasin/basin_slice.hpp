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

/// Two numbers of a start that a slice goes over, the others being fixed.
struct SlicePlane {
  std::array<std::string, 2> names;           ///< columns, with their units: x_m, vx_m_per_s, ...
  std::array<std::vector<double>, 2> values;  ///< across (the faster one) and up, ascending
};

/// A slice of starts of one cell and where they lead, each entry for one start, row by row of the plane.
struct BasinSlice {
  SlicePlane plane;
  sweep::Basins basins;
  std::vector<std::string> statuses;

  basin::LabelGrid grid() const { return {plane.values[0].size(), plane.values[1].size(), basins.numbers}; }
};

/// Side of the boxes for the basin entropy, in starts.
inline constexpr std::size_t entropy_box = 5;

/// Tells the attractors apart to which the rows of a map lead. The cells of its grid are the starts of the
/// plane, in its order, whatever the order of the rows. Throws IoError where a start is missing or is there
/// twice.
BasinSlice read_basin_slice(const std::filesystem::path& map, const SlicePlane& plane,
                            const sweep::Grid& grid);

/// A row for each start: both numbers, `attractor` (empty: failed), `label` (class and order), `status`.
std::string slice_csv(const BasinSlice& slice);

/// A row for each attractor, the most frequent first: `attractor`, `label`, `starts`, `share`,
/// `standard_error`, the three lengths that tell it apart, and the first start that leads to it.
std::string attractors_csv(const BasinSlice& slice);

/// Summary for a terminal: shares, entropies and exponent, each with its meaning.
std::string slice_summary(const BasinSlice& slice);

}  // namespace rubsweep::apps
