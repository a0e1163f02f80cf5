#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>

#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/analysis/branch/orbits/settled_start.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::branch::families {

/// An orbit of a cell of a map.
struct CellOrbit {
  int order = 1;          ///< turns of the period; of an oval loops
  int hits = 0;           ///< number of hits over the period
  Eigen::VectorXd state;  ///< state as closed_orbits() have it: section at the start of one of its turns
  orbits::Closing closing = orbits::Closing::with_the_shaft;
};

/// Outcome of following a stable orbit on the straight way from its cell to a neighbour.
struct Passage {
  std::optional<CellOrbit> arrived;  ///< the orbit there, where it exists and is stable all the way
  std::string_view kind;             ///< else what ends it: the word of an EventKind or an Ending
  double parameter = 0;              ///< and where, in the parameter of the axis that the way is along
};

/// The stable orbit that a cell settles on. Empty where there is none.
std::optional<CellOrbit> stable_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                      std::size_t cell, const orbits::SettledStart& settled,
                                      response::motion::Workspace& workspace);

/// Follows `orbit` from `cell` to `neighbour`, which differs from it on one axis of the grid.
Passage pass(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
             const CellOrbit& orbit, std::size_t neighbour, response::motion::Workspace& workspace);

/// Whether both are one orbit of the cell, by whichever of its turns, or of the largest distances of an oval
/// from the axis, they have it.
bool same_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                const CellOrbit& orbit, const CellOrbit& other, response::motion::Workspace& workspace);

}  // namespace rubsweep::branch::families
