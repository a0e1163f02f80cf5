#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::branch::families {

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
