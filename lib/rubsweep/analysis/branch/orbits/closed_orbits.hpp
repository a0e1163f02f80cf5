#pragma once

#include <string_view>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"

namespace rubsweep::branch::orbits {

/// How an orbit closes.
enum class Closing {
  with_the_shaft,        ///< after whole turns: a fixed point of the section map
  in_the_turning_frame,  ///< an oval: in the frame that turns with the shaft, after a time of its own
};

constexpr std::string_view to_string(Closing closing) {
  return closing == Closing::with_the_shaft ? "with_the_shaft" : "in_the_turning_frame";
}

/// scene_orbits() or oval_orbits(), whose `order` is that of turns or of loops.
OrbitProblem closed_orbits(Closing closing, SceneFamily family, int order,
                           const integrate::run::SolverOptions& solver,
                           integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
