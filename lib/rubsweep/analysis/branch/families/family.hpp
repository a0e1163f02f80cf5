#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/families/family_records.hpp"
#include "rubsweep/analysis/branch/families/passage.hpp"
#include "rubsweep/maps/sweep/grid.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::branch::families {

/// End of a family between one of its cells and a neighbour.
struct FamilyEnd {
  std::size_t inside = 0, outside = 0;
  double speed_hz = 0, unbalance = 0;
  std::string_view kind;  ///< see Passage::kind
};

/// Stable orbits of one kind over the grid of a map: all cells to which the seed's orbit can be continued
/// from neighbour to neighbour without losing stability.
struct Family {
  std::size_t seed = 0;                     ///< first cell whose kick leads to the family
  std::map<std::size_t, CellOrbit> orbits;  ///< orbit of each cell
  std::vector<FamilyEnd> ends;              ///< ends in the order in which they were found
  std::vector<std::size_t> reached;         ///< cells whose kicks lead to the family, ascending

  int order() const { return orbits.at(seed).order; }
  orbits::Closing closing() const { return orbits.at(seed).closing; }
  int hits() const { return orbits.at(seed).hits; }
  /// End of the family on the way from one cell to another; null where the family continues.
  const FamilyEnd* end_between(std::size_t inside, std::size_t outside) const;
};

/// Neighbours of a cell on the grid, up to four.
std::vector<std::size_t> neighbours_of(const sweep::Grid& grid, std::size_t cell);

/// Families of the orbits on which the cells of a map settle.
struct Families {
  std::vector<Family> list;  ///< families by ascending seed
  /// cells whose proven orbit could not be found again as a stable orbit
  std::vector<std::size_t> not_followed;
};

/// Settles the cells `proven` (ascending), whose motion the map calls proven periodic or quasi-periodic, and
/// follows each of their families once over the whole grid. The result depends neither on the number of
/// threads nor on the content of `records`; new results are added to `records`, one call at a time. Once
/// `stop` is true no new work begins, and the result is incomplete. An exception thrown by `records` ends the
/// call.
Families families_of(const sweep::Study& study, std::span<const std::size_t> proven, int threads,
                     const std::atomic<bool>& stop, FamilyRecords& records);

/// Follows all families of the cells `proven`, without records of an earlier run.
Families families_of(const sweep::Study& study, std::span<const std::size_t> proven, int threads,
                     const std::atomic<bool>& stop);

/// Part of the boundary of a family with the same kind of end.
struct OutlineLine {
  std::string_view kind;
  std::vector<std::array<double, 2>> points;  ///< speed in Hz and unbalance
};

/// Boundary of a family over the map, with the domain on the left: the sides between neighbouring cells at
/// which the family ends, joined to lines. A line ends at the edge of the map, or where the kind changes; the
/// next line then begins there.
std::vector<OutlineLine> outline_of(const sweep::Grid& grid, const Family& family);

}  // namespace rubsweep::branch::families
