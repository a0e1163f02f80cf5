#pragma once

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::continuation {

/// The functions whose roots are events, at these multipliers.
MultiplierTests tests_of_multipliers(const Eigen::VectorXcd& multipliers);

/// How they change along the branch, per unit of its length: a difference along the tangent, on which the
/// neighbouring orbits lie but for terms of second order, so that none of them need be found. Zero where the
/// map cannot be made there.
MultiplierTests multiplier_slopes(const orbits::OrbitProblem& problem, const BranchPoint& point);

}  // namespace rubsweep::branch::continuation
