#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// The changes of the sequence of contact modes between two points of a branch, by ascending arclength.
/// Bisection by the sequence comes so near that one stretch of changes appears or disappears; its squared
/// duration is then smooth and zero at the graze, and its root is found by extrapolation from the side that
/// has it, enclosed by the sequences on both sides. Where several things happen at one place, or the
/// sequences differ otherwise, it is bisection to the end and the kind `sequence`. Empty where the piece
/// between the points is not continuous.
std::optional<std::vector<BranchEvent>> grazes_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to);

}  // namespace rubsweep::branch::continuation
