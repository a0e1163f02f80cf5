#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>

#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::branch::families {

/// Orbit of a cell of a map.
struct CellOrbit {
  int order = 1;          ///< number of turns of the period, or of loops for an oval
  int hits = 0;           ///< number of hits over the period
  Eigen::VectorXd state;  ///< state as defined by closed_orbits(): section at the start of one of the turns
  orbits::Closing closing = orbits::Closing::with_the_shaft;
};

/// Result of following a stable orbit from its cell straight to a neighbour.
struct Passage {
  std::optional<CellOrbit> arrived;  ///< orbit in the neighbour, if it exists and is stable all the way
  std::string_view kind;  ///< otherwise the reason why the orbit ends: the word of an EventKind or an Ending
  double parameter = 0;   ///< value of the varied axis at that end
};

/// Stable orbit on which a cell settles; empty where there is none.
std::optional<CellOrbit> stable_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                      std::size_t cell, const orbits::SettledStart& settled,
                                      response::motion::Workspace& workspace);

/// Follows `orbit` from `cell` to `neighbour`, which differs from it on one axis of the grid.
Passage pass(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
             const CellOrbit& orbit, std::size_t neighbour, response::motion::Workspace& workspace);

/// Whether both are the same orbit of the cell. They may begin with different turns or, for an oval, at
/// different maxima of the distance from the axis.
bool same_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                const CellOrbit& orbit, const CellOrbit& other, response::motion::Workspace& workspace);

}  // namespace rubsweep::branch::families
