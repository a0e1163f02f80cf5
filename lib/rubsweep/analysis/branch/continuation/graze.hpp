#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// Changes of the sequence of contact modes between two points of a branch, by ascending arclength. Bisection
/// by the sequence ends when a single stretch of changes appears or disappears. The squared duration of this
/// stretch is smooth and zero at the graze. Its root is extrapolated from the side that has the stretch, and
/// enclosed by the sequences on both sides. If several changes coincide, or the sequences differ otherwise,
/// bisection continues to the end and the kind is `sequence`. Empty where the branch between the points is
/// not continuous.
std::optional<std::vector<BranchEvent>> grazes_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to);

}  // namespace rubsweep::branch::continuation
