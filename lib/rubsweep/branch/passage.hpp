#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string_view>

#include "rubsweep/response/motion/workspace.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::branch {

/// An orbit of a cell of a map.
struct CellOrbit {
  int order = 1;
  int hits = 0;           ///< over the period
  Eigen::VectorXd state;  ///< section at the start of one of its turns
};

/// What becomes of a stable orbit on the straight way from its cell to a neighbour.
struct Passage {
  std::optional<CellOrbit> arrived;  ///< the orbit there, where it exists and is stable all the way
  std::string_view kind;             ///< else what ends it: the word of an EventKind or an Ending
  double parameter = 0;              ///< and where, in the parameter of the axis that the way is along
};

/// The stable orbit near `state`, of a cell that can run. Empty where there is none.
std::optional<CellOrbit> stable_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                      std::size_t cell, int order, const Eigen::VectorXd& state,
                                      response::motion::Workspace& workspace);

/// Follows `orbit` from `cell` to `neighbour`, which differs from it on one axis of the grid.
Passage pass(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
             const CellOrbit& orbit, std::size_t neighbour, response::motion::Workspace& workspace);

/// Whether `state` is where one of the turns of `orbit` begins, in its cell.
bool same_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                const CellOrbit& orbit, const CellOrbit& other, response::motion::Workspace& workspace);

}  // namespace rubsweep::branch
