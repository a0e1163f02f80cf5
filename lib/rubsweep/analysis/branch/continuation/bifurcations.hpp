#pragma once

#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// All events between two neighbouring points of a branch, by ascending arclength. Folds, branch points,
/// period doublings and tori are roots of smooth test functions: the parameter component of the tangent, the
/// determinant of the bordered derivative, det(M + 1), and the determinant of the bialternate product. The
/// branch joins the branch of half its period where the difference of the states half a period apart changes
/// sign. A graze lies where the sequence of contact modes changes; it is located as the root of the squared
/// duration of the new stretch, which is a smooth function. If these events do not explain a change in the
/// number of multipliers outside the unit circle, this change is located by bisection. The slopes of a test
/// function at the ends may suggest two roots in the step. The step is then divided where the function comes
/// nearest to zero, and both parts are searched in the same way. Empty where the branch between the points is
/// not continuous: an orbit between them is not found, or the points belong to different branches.
std::optional<std::vector<BranchEvent>> events_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to,
                                                       bool every_graze);

}  // namespace rubsweep::branch::continuation
