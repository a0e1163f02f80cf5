#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// Graze of an orbit at all its points at once (orbits::EvenContact). The branch has a corner there.
struct EvenGraze {
  BranchPoint before;               ///< orbit just before the graze
  std::vector<BranchEvent> events;  ///< event of each grazing contact, all at one point
  std::optional<BranchPoint>
      beyond;  ///< orbit just beyond the graze, with its tangent pointing away from the graze
};

/// First such graze within about `step` ahead of `here`, along its tangent. Close to the graze, rounding
/// decides the contact modes and therefore the derivative of the map. Orbits are therefore computed at a
/// distance, at penetrations that fall by equal factors. Parameter and state are extrapolated from them to
/// zero penetration. `parameter_error` is the difference of the last extrapolations, plus the effect of the
/// spread of the penetration on the parameter.
std::optional<EvenGraze> even_graze_ahead(const orbits::OrbitProblem& problem, const BranchPoint& here,
                                          double step);

/// Whether an even contact touches on one of the two orbits but not on the other.
bool even_contact_changes(const BranchPoint& a, const BranchPoint& b);

}  // namespace rubsweep::branch::continuation
