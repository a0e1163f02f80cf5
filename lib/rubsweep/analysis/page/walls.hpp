#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// A wall as it is drawn with an orbit, in metres from the rotor's rest position.
struct Wall {
  bool around = false;                   ///< around the rotor, else flat
  std::array<double, 2> normal{0, 1};    ///< of a flat wall: from the rest position towards it
  std::array<double, 2> centre_m{0, 0};  ///< of one around the rotor
  double clearance_m = 0;
  bool at_orbit = true;  ///< it stands at the point of the shaft whose orbit is drawn

  friend bool operator==(const Wall&, const Wall&) = default;
};

/// The walls of all cells. Only keys move them, speed and unbalance do not.
struct Walls {
  std::vector<std::vector<Wall>> lists;  ///< each once
  /// Which of the lists holds for each combination of values of the axes over keys, in the order of the
  /// cells; 0 for the only one where there are no such axes.
  std::vector<std::size_t> list_of_keys;
};

/// Walls of the study; where keys have values that are not allowed there are none, as there is no motion.
Walls walls_of(const sweep::Study& study);

}  // namespace rubsweep::page
