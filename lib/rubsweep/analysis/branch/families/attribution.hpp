#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::branch::families {

/// Kind of quiet motion of a cell, which is there in closed form.
enum class Quiet {
  stable,    ///< it touches nothing, and free vibration about it decays
  unstable,  ///< it touches nothing, but free vibration grows
  touches,   ///< it would reach a wall, or there is none
};

/// The quiet motion of every cell of the grid.
std::vector<Quiet> quiet_cells(const sweep::Study& study);

/// Why two neighbouring cells of a map have different labels.
enum class Attribution {
  ceases,  ///< between them a motion that one of the kicks leads to ends, or loses its stability
  basin,   ///< a motion that one of the kicks leads to, the quiet one included, exists and is stable in both
           ///< cells: the kick of the other one no longer reaches it
  unresolved,  ///< neither cell has a motion that could be followed, or following it failed
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
  /// Kind of event where a motion ceases; where unresolved why, or empty; of a basin empty where both motions
  /// are on both sides, `one_motion` where that is known of one of them, and the other one may cease as well.
  std::string_view kind;
};

constexpr std::string_view one_motion = "one_motion";

/// Whether `kind` is something that happens to an orbit, and not to following it.
bool is_an_end(std::string_view kind);

/// Every pair of neighbouring cells with different labels. For each cell of the grid: its label, and its
/// quiet motion, which is what the cells labelled `quiet_label` settle on.
std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families, std::span<const Quiet> quiet,
                               std::string_view quiet_label);

}  // namespace rubsweep::branch::families
