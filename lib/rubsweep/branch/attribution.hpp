#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/branch/family.hpp"

namespace rubsweep::branch {

/// Why two neighbouring cells of a map have different labels.
enum class Attribution {
  ceases,  ///< between them an orbit that one of the kicks leads to ends, or loses its stability
  basin,   ///< that orbit exists and is stable in both cells: the kick of the other one no longer reaches it
  unresolved,  ///< neither cell has an orbit that could be followed, or following it failed
};

constexpr std::string_view to_string(Attribution attribution) {
  switch (attribution) {
    case Attribution::ceases:
      return "ceases";
    case Attribution::basin:
      return "basin";
    case Attribution::unresolved:
      return "unresolved";
  }
  return "";
}

struct MapEdge {
  std::size_t first = 0, second = 0;
  Attribution attribution = Attribution::unresolved;
  std::string_view kind;  ///< of what ceases; of what is unresolved why, or empty
};

/// Whether `kind` is something that happens to an orbit, and not to following it.
bool is_an_end(std::string_view kind);

/// Every pair of neighbouring cells with different labels, one label per cell of the grid.
std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families);

}  // namespace rubsweep::branch
