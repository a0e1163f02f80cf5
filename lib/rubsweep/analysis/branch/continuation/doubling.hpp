#pragma once

#include <optional>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// First orbit of twice the period beside a period doubling, a small way along the vector whose sign every
/// period turns: from there `follow` follows the doubled branch away from the doubling. The other side of it
/// is the same branch shifted by a period. `doubled`: the problem with twice the turns. Empty where none is
/// found.
std::optional<BranchPoint> doubled_start(const orbits::OrbitProblem& doubled, const BranchPoint& doubling);

}  // namespace rubsweep::branch::continuation
