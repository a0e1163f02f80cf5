#pragma once

#include <vector>

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

}  // namespace rubsweep::branch::families
