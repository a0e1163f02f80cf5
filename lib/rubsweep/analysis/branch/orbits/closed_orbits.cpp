#include "rubsweep/analysis/branch/orbits/closed_orbits.hpp"

#include <utility>

#include "rubsweep/analysis/branch/orbits/oval_orbits.hpp"

namespace rubsweep::branch::orbits {

OrbitProblem closed_orbits(Closing closing, SceneFamily family, int order,
                           const integrate::run::SolverOptions& solver,
                           integrate::exact::modes::ModeCache& modes) {
  return closing == Closing::in_the_turning_frame ? oval_orbits(std::move(family), order, solver)
                                                  : scene_orbits(std::move(family), order, solver, modes);
}

}  // namespace rubsweep::branch::orbits
