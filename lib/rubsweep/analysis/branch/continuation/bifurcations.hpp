#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// Everything that happens between two neighbouring points of a branch, by ascending arclength. Folds, branch
/// points, period doublings and tori are roots of functions that are smooth along the branch: the parameter's
/// component of the tangent, the determinant of the bordered derivative, det(M + 1), and the determinant of
/// the bialternate product; a branch joins that of half its period where the difference of the states half a
/// period apart changes sign. A graze is found where the sequence of contact modes changes, and is the root
/// of the squared duration of what appears there, which is smooth and zero at the graze. Where the count of
/// multipliers outside the unit circle changes in a way that these do not explain, the place is found by
/// bisection of that count. A step in which the slopes of these functions at its ends let two roots of one of
/// them be expected is parted where that function comes nearest to zero, and both parts are looked at in the
/// same way. Empty where the piece between the points is not continuous: an orbit on the way is not found, or
/// the two points belong to different branches.
std::optional<std::vector<BranchEvent>> events_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to,
                                                       bool every_graze);

}  // namespace rubsweep::branch::continuation
