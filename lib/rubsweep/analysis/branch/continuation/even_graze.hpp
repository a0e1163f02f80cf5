#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// A graze of an orbit that touches everywhere at once (orbits::EvenContact). The branch has a corner there.
struct EvenGraze {
  BranchPoint before;               ///< orbit just this side of it
  std::vector<BranchEvent> events;  ///< event of each contact that grazes, all at one point
  std::optional<BranchPoint>
      beyond;  ///< orbit just behind it, with its tangent away from it, if there is one
};

/// The first such graze within about `step` ahead of `here`, along its tangent. Within rounding of the graze
/// the modes that a solver meets are chance, and so is the derivative of the map: orbits are found at a
/// distance, by penetrations that fall by a factor of four each, and parameter and state are extrapolated
/// from them to the penetration zero. `parameter_error` is what the last extrapolations differ by, and what
/// the spread of the penetration makes of the parameter.
std::optional<EvenGraze> even_graze_ahead(const orbits::OrbitProblem& problem, const BranchPoint& here,
                                          double step);

/// Whether an even contact of both orbits touches on one of them and not on the other.
bool even_contact_changes(const BranchPoint& a, const BranchPoint& b);

}  // namespace rubsweep::branch::continuation
