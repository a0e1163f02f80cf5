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

/// Where a family ends between a cell that it has an orbit in and a neighbour.
struct FamilyEnd {
  std::size_t inside = 0, outside = 0;
  double speed_hz = 0, unbalance = 0;
  std::string_view kind;  ///< see Passage::kind
};

/// Stable orbits of one kind over the grid of a map: all cells to which the orbit of the seed goes on, from
/// neighbour to neighbour, without losing its stability.
struct Family {
  std::size_t seed = 0;                     ///< the first cell whose kick leads there
  std::map<std::size_t, CellOrbit> orbits;  ///< orbits by their cells
  std::vector<FamilyEnd> ends;              ///< ends in the order in which they were met
  std::vector<std::size_t> reached;         ///< cells whose kick leads to the family, ascending

  int order() const { return orbits.at(seed).order; }
  orbits::Closing closing() const { return orbits.at(seed).closing; }
  int hits() const { return orbits.at(seed).hits; }
  /// The end on the way from one cell to another; null where the family goes on.
  const FamilyEnd* end_between(std::size_t inside, std::size_t outside) const;
};

/// Neighbours of a cell on the grid: up to four.
std::vector<std::size_t> neighbours_of(const sweep::Grid& grid, std::size_t cell);

/// Families of the orbits that the cells of a map settle on.
struct Families {
  std::vector<Family> list;               ///< families by ascending seed
  std::vector<std::size_t> not_followed;  ///< cells whose proven orbit is not found again as a stable one
};

/// Settles the cells `proven` (ascending), whose motion a map calls periodic or quasi-periodic and proven,
/// and follows every family that they belong to over the whole grid, each once. The result does not depend on
/// the number of threads, nor on what `records` already knew: what they do not is added to them, one call at
/// a time. Once `stop` is true nothing more is begun, and what is returned is not whole. What the records
/// throw ends it.
Families families_of(const sweep::Study& study, std::span<const std::size_t> proven, int threads,
                     const std::atomic<bool>& stop, FamilyRecords& records);

/// The same from the beginning.
Families families_of(const sweep::Study& study, std::span<const std::size_t> proven, int threads,
                     const std::atomic<bool>& stop);

/// A piece of the boundary of a family, of one kind.
struct OutlineLine {
  std::string_view kind;
  std::vector<std::array<double, 2>> points;  ///< speed in Hz and unbalance
};

/// The boundary of a family over the map: the places at which it ends on the ways between neighbouring cells,
/// joined around the domain with the domain on the left. Lines end where the map does, and where the kind
/// changes; the next one then begins where the last one ended.
std::vector<OutlineLine> outline_of(const sweep::Grid& grid, const Family& family);

}  // namespace rubsweep::branch::families
